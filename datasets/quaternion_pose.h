#pragma once
/// A pose as logs store it: position and unit quaternion (testbed of paper Sec. 4.1.1).
#include <Eigen/Geometry>

#include "ldm/types.h"

namespace datasets {

/// What a log keeps of a pose. Simulator and log reader both build the `ldm::Pose` from these seven
/// numbers with `to_pose`, so that a log reads back bit for bit.
struct QuaternionPose {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m]
  double w = 1, x = 0, y = 0, z = 0;                      ///< of unit norm
};

inline ldm::Pose to_pose(const QuaternionPose& p) {
  return {Eigen::Quaterniond(p.w, p.x, p.y, p.z).toRotationMatrix(), p.translation};
}

/// Nearest unit quaternion with w >= 0.
inline QuaternionPose to_quaternion_pose(const ldm::Pose& pose) {
  Eigen::Quaterniond q(pose.rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return {pose.translation, q.w(), q.x(), q.y(), q.z()};
}

/// T_a_c = T_a_b T_b_c.
inline ldm::Pose composed(const ldm::Pose& T_a_b, const ldm::Pose& T_b_c) {
  return {T_a_b.rotation * T_b_c.rotation, T_a_b * T_b_c.translation};
}

/// T_b_a.
inline ldm::Pose inverse(const ldm::Pose& T_a_b) {
  return {T_a_b.rotation.transpose(), -(T_a_b.rotation.transpose() * T_a_b.translation)};
}

}  // namespace datasets
