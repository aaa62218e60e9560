#pragma once
/// From the pose that a recording knows to those a scan needs (paper Sec. 3.1).
#include <Eigen/Geometry>
#include <numbers>
#include <optional>
#include <string>

#include "datasets/quaternion_pose.h"
#include "datasets/recording/scans/input_parameters.h"

namespace datasets {

/// T_uav_sensor of input.sensor.*: R = Rz(yaw) Ry(pitch) Rx(roll).
inline ldm::Pose mount_of(const SensorMountParameters& p) {
  const auto turn = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
  };
  return {(turn(p.yaw, Eigen::Vector3d::UnitZ()) * turn(p.pitch, Eigen::Vector3d::UnitY()) *
           turn(p.roll, Eigen::Vector3d::UnitX()))
              .toRotationMatrix(),
          {p.x, p.y, p.z}};
}

/// The same where the recording says it, unless input.sensor.from_log = false.
/// @param place in the recording, for messages
/// @throws ldm::InvalidInput if input.sensor.* says it as well.
inline ldm::Pose mount_of(const SensorMountParameters& p, const std::optional<ldm::Pose>& recorded,
                          const std::string& place) {
  ldm::Pose given = mount_of(p);
  if (!recorded || !p.from_log) return given;
  if (given.translation.isZero() && given.rotation.isIdentity(1e-12)) return *recorded;
  throw ldm::InvalidInput(place +
                          ": the log says where its sensor sits: allowed: input.sensor.* as they "
                          "are, or input.sensor.from_log = false");
}

/// @param pose in the world: of the vehicle if `of` says so, else of the sensor
inline void set_poses(const ldm::Pose& pose, PosesOf of, const ldm::Pose& T_uav_sensor,
                      ldm::Scan& scan) {
  const bool sensor = of != PosesOf::kVehicle;
  scan.T_world_sensor = sensor ? pose : composed(pose, T_uav_sensor);
  scan.T_world_uav = sensor ? composed(pose, inverse(T_uav_sensor)) : pose;
}

}  // namespace datasets
