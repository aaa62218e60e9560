#include "datasets/recording/formats/ros/bag_contents.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

#include "datasets/files/text.h"
#include "datasets/recording/formats/ros/cloud_message.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/given_trajectory.h"
#include "datasets/recording/scans/sensor_mount.h"

namespace datasets {
namespace {

using Names = std::vector<std::string>;
using Moving = std::set<std::pair<std::string, std::string>>;

bool is_fixed(const BagTopic& topic) {
  return topic.name.ends_with("tf_static");
}

/// @param moving frames whose first pose is in the tree
void look_into(const BagMessage& message, BagContents::Topic& entry, FrameTree& tree,
               Moving& moving) {
  const BagTopic& topic = entry.topic;
  const bool tf = is_tf(topic.type);
  const bool first = entry.messages == 1;
  try {
    if (first && is_cloud(topic.type)) {
      entry.frame = MessageFields(message.bytes, topic.encoding).header().frame;
    }
    if (!tf && !(first && (is_odometry(topic.type) || is_pose(topic.type)))) return;
    std::vector<StampedTransform> transforms;
    if (!read_transforms(topic, message.bytes, transforms).empty()) return;
    for (const StampedTransform& transform : transforms) {
      if (!tf) {
        entry.frame = transform.parent;
        entry.child = transform.child;
      } else if (is_fixed(topic) || moving.insert({transform.parent, transform.child}).second) {
        tree.add(transform, is_fixed(topic));
      }
    }
  } catch (const ShortBytes&) {  // which is told when its turn comes
  }
}

Names names_of(const BagContents& contents, const std::function<bool(const std::string&)>& type) {
  Names names;
  for (const auto& entry : contents.topics) {
    if (entry.messages > 0 && type(entry.topic.type)) names.push_back(entry.topic.name);
  }
  return names;
}

/// Chooses from a bag's topics, or says why not.
class Planner {
 public:
  Planner(const std::filesystem::path& path, const BagContents& contents,
          const RecordingOptions& options)
      : name_(path.string()), contents_(contents), options_(options) {}

  BagPlan plan() {
    choose_points();
    choose_poses();
    plan_.world_frame = contents_.tree.root_of(plan_.sensor_frame);
    if (plan_.poses == BagPoses::kStill) mount_still();
    if (options_.poses && plan_.poses != BagPoses::kStill) mount_poses("");
    if (plan_.poses == BagPoses::kTopic) mount_poses(contents_.find(plan_.poses_topic)->child);
    const std::string conflict = contents_.tree.conflict(plan_.sensor_frame);
    if (plan_.poses == BagPoses::kTf && !conflict.empty()) {
      reject("a frame has two parents in TF, " + conflict + ": allowed: --poses-topic of " +
             listed(odometries_and_poses()) + ", or --poses FILE");
    }
    return plan_;
  }

 private:
  void choose_points() {
    const Names clouds = names_of(contents_, is_cloud);
    if (options_.points) {
      plan_.points = *options_.points;
      if (std::find(clouds.begin(), clouds.end(), plan_.points) == clouds.end()) {
        reject("--points " + plan_.points + ": allowed: " + listed(clouds));
      }
    } else if (clouds.empty()) {
      reject("has no scans: allowed: topics of sensor_msgs/PointCloud2 or Livox's CustomMsg");
    } else if (clouds.size() > 1) {
      reject("scans of several topics: allowed: --points with one of " + listed(clouds));
    } else {
      plan_.points = clouds.front();
    }
    plan_.sensor_frame = options_.sensor_frame ? frame_name(*options_.sensor_frame)
                                               : contents_.find(plan_.points)->frame;
  }

  void choose_poses() {
    if (options_.input.poses == PoseSource::kStill) return;
    if (options_.poses) {
      open_trajectory(trajectory_in(*options_.poses),
                      options_.time_unit);  // which says if it is none
      plan_.poses = BagPoses::kFile;
      return;
    }
    if (options_.poses_topic) return take_topic(*options_.poses_topic);
    const bool odometry = options_.input.poses == PoseSource::kOdometry;
    if (!odometry && contents_.tree.moves(plan_.sensor_frame)) {
      plan_.poses = BagPoses::kTf;
      return;
    }
    Names topics = names_of(contents_, is_odometry);
    if (topics.empty() && !odometry) topics = names_of(contents_, is_pose);
    if (topics.size() == 1) return take_topic(topics.front());
    if (topics.size() > 1) {
      reject("poses of several topics: allowed: --poses-topic with one of " + listed(topics));
    }
    reject("has no poses of " + plan_.sensor_frame +
           ": allowed: --poses FILE (docs/recordings.md says where from), or --set "
           "input.poses=still for a sensor at rest");
  }

  void take_topic(const std::string& name) {
    const BagContents::Topic* const topic = contents_.find(name);
    const std::string type = topic == nullptr ? "" : topic->topic.type;
    plan_.poses_topic = name;
    if (is_odometry(type) || is_pose(type)) {
      plan_.poses = BagPoses::kTopic;
    } else if (is_tf(type) && contents_.tree.moves(plan_.sensor_frame)) {
      plan_.poses = BagPoses::kTf;
    } else if (is_tf(type)) {
      reject("--poses-topic " + name + ": no frame above " + plan_.sensor_frame +
             " moves: allowed: --sensor-frame with one of TF, or " +
             listed(odometries_and_poses()));
    } else {
      reject("--poses-topic " + name + ": allowed: " + listed(odometries_and_poses()));
    }
  }

  Names odometries_and_poses() const {
    return names_of(contents_,
                    [](const std::string& type) { return is_odometry(type) || is_pose(type); });
  }

  /// At rest it is the vehicle that stands at the origin: the root of fixed frames, if there are.
  void mount_still() {
    plan_.of_sensor = false;
    plan_.T_vehicle_sensor = mount_of(options_.input.sensor);
    const std::string root = contents_.tree.root_of(plan_.sensor_frame);
    const auto mount = contents_.tree.fixed_between(root, plan_.sensor_frame);
    if (!options_.input.sensor.from_log || !mount || root == plan_.sensor_frame) return;
    if (!plan_.T_vehicle_sensor.translation.isZero() ||
        !plan_.T_vehicle_sensor.rotation.isIdentity(1e-12)) {
      reject("TF says where " + plan_.sensor_frame + " sits in " + root +
             ": allowed: input.sensor.* as they are, or input.sensor.from_log = false");
    }
    plan_.T_vehicle_sensor = *mount;
  }

  /// @param child the frame whose poses they are; empty if they do not say
  void mount_poses(const std::string& child) {
    const PosesOf of = options_.input.poses_of;
    if (of == PosesOf::kCamera) {
      reject("input.poses_of = camera: allowed: in a KITTI folder with a calib.txt");
    }
    plan_.T_vehicle_sensor = mount_of(options_.input.sensor);
    plan_.of_sensor = of != PosesOf::kVehicle;
    if (of != PosesOf::kAuto || child.empty() || child == plan_.sensor_frame) return;
    const auto mount = contents_.tree.fixed_between(child, plan_.sensor_frame);
    if (!mount) {
      reject("poses of " + child + ", scans of " + plan_.sensor_frame +
             ", and no fixed transform between: allowed: --sensor-frame, --set "
             "input.poses_of=sensor, or =vehicle with input.sensor.*");
    }
    plan_.T_vehicle_sensor = *mount;
    plan_.of_sensor = false;
  }

  static std::string listed(const Names& names) {
    return names.empty() ? "nothing in this bag" : joined(names);
  }
  [[noreturn]] void reject(const std::string& message) const {
    throw ldm::InvalidInput(name_ + ": " + message);
  }

  std::string name_;
  const BagContents& contents_;
  const RecordingOptions& options_;
  BagPlan plan_;
};

}  // namespace

const BagContents::Topic* BagContents::find(const std::string& name) const {
  const auto found = std::find_if(topics.begin(), topics.end(),
                                  [&](const Topic& topic) { return topic.topic.name == name; });
  return found == topics.end() ? nullptr : &*found;
}

BagContents read_contents(const std::filesystem::path& path, bool whole) {
  constexpr double kEnough = 1;  // [s] after the first scan
  BagContents contents;
  Moving moving;
  std::optional<double> first_scan;
  try {
    const std::unique_ptr<BagFile> bag = open_bag(path);
    for (BagMessage message; bag->next(message);) {
      for (std::size_t i = contents.topics.size(); i < bag->topics().size(); ++i) {
        contents.topics.push_back({.topic = bag->topics()[i], .frame = {}, .child = {}});
      }
      BagContents::Topic& topic = contents.topics[message.topic];
      ++topic.messages;
      topic.first = std::min(topic.first, message.time);
      topic.last = std::max(topic.last, message.time);
      look_into(message, topic, contents.tree, moving);
      if (!first_scan && is_cloud(topic.topic.type)) first_scan = message.time;
      if (!whole && first_scan && message.time > *first_scan + kEnough) break;
    }
  } catch (const BrokenFrame&) {  // which is told when its turn comes
  }
  return contents;
}

BagPlan plan_of(const std::filesystem::path& path, const BagContents& contents,
                const RecordingOptions& options) {
  return Planner(path, contents, options).plan();
}

BagPlan plan_of(const std::filesystem::path& path, const RecordingOptions& options) {
  try {
    return plan_of(path, read_contents(path, false), options);
  } catch (const ldm::InvalidInput&) {
    return plan_of(path, read_contents(path, true), options);
  }
}

std::string text_of(const BagPlan& plan) {
  std::string text = "scans of " + plan.points + " in " + plan.sensor_frame + ", ";
  switch (plan.poses) {
    case BagPoses::kStill:
      return text + "at rest";
    case BagPoses::kFile:
      return text + "poses of a file";
    case BagPoses::kTf:
      return text + "poses of TF in " + plan.world_frame;
    default:
      return text + "poses of " + plan.poses_topic + ", the " +
             (plan.of_sensor ? "sensor's" : "vehicle's");
  }
}

}  // namespace datasets
