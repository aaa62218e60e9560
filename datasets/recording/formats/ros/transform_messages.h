#pragma once
/// Poses in messages of ROS: TF, nav_msgs/Odometry, geometry_msgs/PoseStamped and
/// PoseWithCovarianceStamped (no paper section).
#include <string>
#include <vector>

#include "datasets/recording/formats/ros/message_fields.h"
#include "datasets/recording/scans/trajectory.h"

namespace datasets {

struct StampedTransform {
  std::string parent, child;  ///< of a PoseStamped the child has no name
  StampedPose T_parent_child;
};

bool is_tf(const std::string& type);        ///< tf2_msgs/TFMessage, tf/tfMessage
bool is_odometry(const std::string& type);  ///< nav_msgs/Odometry
bool is_pose(const std::string& type);      ///< one with a pose alone

/// The transforms of a message of one of these types.
/// @return an empty text, or what is wrong: a quaternion that is none
/// @throws ShortBytes if the message ends too early.
std::string read_transforms(const BagTopic& topic, std::string_view bytes,
                            std::vector<StampedTransform>& transforms);

}  // namespace datasets
