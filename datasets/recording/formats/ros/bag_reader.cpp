#include "datasets/recording/formats/ros/bag_reader.h"

#include <exception>
#include <utility>

#include "datasets/files/text.h"
#include "datasets/recording/formats/ros/bag_contents.h"
#include "datasets/recording/formats/ros/cloud_message.h"
#include "datasets/recording/rays/scan_rays.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/deskew.h"
#include "datasets/recording/scans/given_trajectory.h"
#include "datasets/recording/scans/scan_trajectory.h"
#include "datasets/recording/scans/sensor_mount.h"
#include "datasets/recording/scans/waiting_scan_reader.h"

namespace datasets {
namespace {

/// Where vehicle and sensor were, by the source that the plan names.
class BagTrajectory {
 public:
  BagTrajectory(const BagPlan& plan, const RecordingOptions& options)
      : plan_(plan), longest_gap_(options.input.pose_gap) {
    if (plan_.poses == BagPoses::kFile) file_.emplace(options);
  }

  /// Where the poses have a line for each scan: takes that of the next one.
  /// @throws BrokenFrame naming the line that is broken.
  void take_scan(double stamp) {
    if (file_) file_->take_scan(stamp);
  }

  /// Takes a message of TF, or of the topic with the poses.
  /// @return an empty text, or what is wrong with it
  std::string take(const BagTopic& topic, std::string_view bytes) {
    const bool tf = plan_.poses == BagPoses::kTf && is_tf(topic.type);
    if (!tf && (plan_.poses != BagPoses::kTopic || topic.name != plan_.poses_topic)) return {};
    std::string failure = read_transforms(topic, bytes, transforms_);
    for (const StampedTransform& transform : transforms_) {
      if (tf) {
        tree_.add(transform, topic.name.ends_with("tf_static"));
      } else {
        track_.add(transform.T_parent_child);  // one that goes back in time is left out
      }
    }
    return failure;
  }

  /// True if no later message changes what `at` gives.
  bool covers(double time) const {
    if (plan_.poses == BagPoses::kTf) {
      return tree_.covers(plan_.sensor_frame, plan_.world_frame, time);
    }
    return file_ ? file_->covers(time) : plan_.poses == BagPoses::kStill || track_.covers(time);
  }

  /// Sets the poses of `scan` at a time. @return false if there are none, and `gap` says where
  bool at(double time, ldm::Scan& scan, std::string& gap) {
    if (plan_.poses == BagPoses::kTf) {
      const auto place = tree_.at(plan_.sensor_frame, plan_.world_frame, time, longest_gap_, gap);
      if (!place) return false;
      scan.T_world_sensor = place->T_root_frame;
      scan.T_world_uav = place->T_root_vehicle;
      return true;
    }
    std::optional<ldm::Pose> pose = ldm::Pose();
    if (plan_.poses == BagPoses::kTopic) pose = track_.at(time, longest_gap_);
    if (file_) pose = file_->at(time, longest_gap_);
    if (!pose) {
      gap = file_ ? "the file of --poses has " + file_->around(time)
                  : plan_.poses_topic + " has " + track_.around(time);
      return false;
    }
    set_poses(*pose, plan_.of_sensor ? PosesOf::kSensor : PosesOf::kVehicle, plan_.T_vehicle_sensor,
              scan);
    return true;
  }

 private:
  BagPlan plan_;
  double longest_gap_;
  FrameTree tree_;
  PoseTrack track_;
  std::optional<ScanTrajectory> file_;
  std::vector<StampedTransform> transforms_;
};

/// A scan whose poses may not have been read yet.
struct WaitingCloud {
  CloudMessage cloud;
  std::string place, failure;
  double end = 0;  ///< when its last point was measured [s]
};

class BagReader : public WaitingScanReader<WaitingCloud> {
 public:
  BagReader(const std::filesystem::path& path, const RecordingOptions& options)
      : plan_(plan_of(path, options)),
        bag_(open_bag(path)),
        trajectory_(plan_, options),
        deskew_(options.input.deskew && plan_.poses != BagPoses::kStill),
        gap_(options.input.pose_gap),
        tell_others_(!options.points),
        rays_(options.input.no_returns != NoReturns::kLog) {}

  InputCounts counts() const override {
    InputCounts counts = counts_;
    rays_.count(counts.other);
    return counts;
  }

 private:
  bool covers(const WaitingCloud& waiting) const override {
    return trajectory_.covers(waiting.end);
  }

  void read_on() override {
    BagMessage message;
    try {
      if (!bag_->next(message)) return end();
    } catch (const BrokenFrame&) {
      return end(std::current_exception());
    }
    const BagTopic& topic = bag_->topics()[message.topic];
    if (topic.name == plan_.points) {
      take_scan(topic, message.bytes);
    } else if (tell_others_ && is_cloud(topic.type)) {
      ++counts_.other_sensors[topic.name];
    } else {
      take_pose(topic, message.bytes);
    }
  }

  void take_scan(const BagTopic& topic, std::string_view bytes) {
    WaitingCloud scan;
    scan.place = bag_->place();
    try {
      scan.failure = read_cloud(topic, bytes, deskew_, scan.cloud);
      trajectory_.take_scan(scan.cloud.header.stamp);
    } catch (const ShortBytes& error) {
      scan.failure = error.what();
    } catch (const BrokenFrame& error) {
      scan.failure = error.what();
    }
    scan.end = end_of(scan.cloud.header.stamp, scan.cloud.delays);
    wait(std::move(scan));
  }

  void take_pose(const BagTopic& topic, std::string_view bytes) {
    std::string failure;
    try {
      failure = trajectory_.take(topic, bytes);
    } catch (const ShortBytes&) {
      failure = "cut short";
    }
    if (!failure.empty()) ++counts_.other["broken messages with poses"];
  }

  void take(WaitingCloud& waiting, ldm::Scan& scan) override {
    const double time = waiting.cloud.header.stamp;
    if (!waiting.failure.empty()) {
      throw BrokenFrame("broken scan", place() + ": " + waiting.failure);
    }
    if (time == 0)
      throw BrokenFrame("no time", place() + ": the scan's stamp is 0: allowed: a time");
    scan.time = time;
    std::string gap;
    if (!trajectory_.at(time, scan, gap)) reject_pose(time, gap);
    scan.points = std::move(waiting.cloud.points);
    TimedRays rays = rays_.of(scan.points, waiting.cloud.delays);
    ldm::Scan moment;
    const auto sensor_at = [&](double delay) -> std::optional<ldm::Pose> {
      if (!trajectory_.at(time + delay, moment, gap)) return {};
      return moment.T_world_sensor;
    };
    if (!deskew(waiting.cloud.delays, scan.T_world_sensor, sensor_at, scan.points, rays)) {
      reject_pose(time, gap);
    }
    scan.no_returns = std::move(rays.rays);
  }

  [[noreturn]] void reject_pose(double time, const std::string& gap) const {
    throw BrokenFrame("no pose", place() + ": no pose for the scan at " + decimal(time) +
                                     " s: " + gap +
                                     ": allowed: a gap of input.pose_gap_s = " + decimal(gap_));
  }

  BagPlan plan_;
  std::unique_ptr<BagFile> bag_;
  BagTrajectory trajectory_;
  bool deskew_;
  double gap_;        // [s]
  bool tell_others_;  // of topics with scans that were not chosen by name
  ScanRays rays_;
  InputCounts counts_;
};

/// Of a file with a line for each scan the bag is read once before: a line too few or too many
/// would give each scan behind it the pose of another.
void check_lines(const std::filesystem::path& path, const RecordingOptions& options) {
  if (!counts_scans(*options.poses, 0)) return;
  const BagContents contents = read_contents(path, true);
  const std::int64_t scans = contents.find(plan_of(path, contents, options).points)->messages;
  check_pose_count(options, scans, path.string());
}

}  // namespace

std::unique_ptr<ScanReader> open_bag_recording(const std::filesystem::path& path,
                                               const RecordingOptions& options) {
  RecordingOptions resolved = options;
  if (options.poses) {
    resolved.poses = trajectory_in(*options.poses);
    check_lines(path, resolved);
  }
  if (options.times) {
    throw ldm::InvalidInput("--times " + options.times->string() +
                            ": allowed: with a folder of scans; a bag has its own");
  }
  return std::make_unique<BagReader>(path, resolved);
}

}  // namespace datasets
