#include "datasets/recording/formats/ros/transform_messages.h"

#include <cmath>

namespace datasets {
namespace {

/// A position or translation and a quaternion. @return false if that is none
bool take_pose(MessageFields& fields, ldm::Pose& pose) {
  for (int i = 0; i < 3; ++i) pose.translation[i] = fields.number<double>();
  double q[4];
  for (double& part : q) part = fields.number<double>();
  Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  constexpr double kWrongNorm = 0.05;
  if (!(std::abs(rotation.norm() - 1) < kWrongNorm) || !pose.translation.allFinite()) return false;
  rotation.normalize();
  pose.rotation = rotation.toRotationMatrix();
  return true;
}

}  // namespace

bool is_tf(const std::string& type) {
  return type == "tf2_msgs/TFMessage" || type == "tf/tfMessage";
}
bool is_odometry(const std::string& type) {
  return type == "nav_msgs/Odometry";
}
bool is_pose(const std::string& type) {
  return type == "geometry_msgs/PoseStamped" || type == "geometry_msgs/PoseWithCovarianceStamped";
}

std::string read_transforms(const BagTopic& topic, std::string_view bytes,
                            std::vector<StampedTransform>& transforms) {
  transforms.clear();
  MessageFields fields(bytes, topic.encoding);
  const bool tf = is_tf(topic.type);
  const std::uint32_t count = tf ? fields.number<std::uint32_t>() : 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    StampedTransform transform;
    const MessageHeader header = fields.header();
    transform.parent = header.frame;
    transform.T_parent_child.time = header.stamp;
    if (tf || is_odometry(topic.type)) transform.child = frame_name(fields.text());
    if (!take_pose(fields, transform.T_parent_child.pose)) {
      return "no pose of finite numbers and a quaternion of norm 1";
    }
    transforms.push_back(std::move(transform));
  }
  return {};
}

}  // namespace datasets
