#pragma once
/// What is in a bag, and what of it is taken (no paper section).
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "datasets/recording/formats/ros/bag_file.h"
#include "datasets/recording/formats/ros/frame_tree.h"
#include "datasets/recording/scans/recording_options.h"

namespace datasets {

struct BagContents {
  struct Topic {
    BagTopic topic;
    std::int64_t messages = 0;
    double first = std::numeric_limits<double>::infinity();  ///< time of recording [s]
    double last = -std::numeric_limits<double>::infinity();
    std::string frame, child;  ///< of its first message: scans, odometry
  };
  std::vector<Topic> topics;
  FrameTree tree;  ///< of its moving frames one pose each

  const Topic* find(const std::string& name) const;
};

/// @param whole all of the bag, or its beginning: until a second after the first scan
/// @throws ldm::InvalidInput if it cannot be read; damage ends it.
BagContents read_contents(const std::filesystem::path& path, bool whole);

enum class BagPoses { kStill, kFile, kTf, kTopic };

struct BagPlan {
  std::string points;        ///< topic of the scans
  std::string sensor_frame;  ///< that the scans are in
  std::string world_frame;   ///< of kTf: its root
  BagPoses poses = BagPoses::kStill;
  std::string poses_topic;  ///< of kTopic
  bool of_sensor = true;    ///< the poses of topics and files are the sensor's, else the vehicle's
  ldm::Pose T_vehicle_sensor;
};

/// Topics and frames as the options name them, else as the bag leaves no choice: its one topic of
/// scans; TF that moves the sensor, else its one topic of odometry, else its one topic of poses.
/// @throws ldm::InvalidInput with what is allowed where there is a choice, or nothing.
BagPlan plan_of(const std::filesystem::path& path, const BagContents& contents,
                const RecordingOptions& options);
/// The same by the beginning of a bag or, if that is not enough, by all of it.
BagPlan plan_of(const std::filesystem::path& path, const RecordingOptions& options);

/// The plan in one line: `scans of /points in lidar, poses of TF in map`.
std::string text_of(const BagPlan& plan);

}  // namespace datasets
