#pragma once
/// A simulated scenario, frame by frame: scans of a LiDAR on a flying UAV, with the truth (paper
/// Sec. 4.1.1).
#include <cstdint>
#include <optional>

#include "datasets/frame.h"
#include "datasets/quaternion_pose.h"
#include "datasets/scenario/lidar.h"
#include "datasets/scenario/lidar_caster.h"
#include "datasets/scenario/scenario.h"
#include "datasets/scenario/world.h"

namespace datasets {

/// Frame k is taken at k / rate [s]. The same scenario and seed give the same frames bit for bit.
class Simulation : public FrameSource {
 public:
  /// @param frames stop after so many, at most the scenario's; the world is the same
  /// @throws ldm::InvalidInput on a scenario or number of frames out of range, std::runtime_error
  /// if the scenario leaves no room for a world (see `draw_world`).
  Simulation(const Scenario& scenario, std::uint64_t seed, std::optional<std::int64_t> frames = {});

  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override { return frames_; }

  const LidarModel& lidar() const { return caster_.model(); }
  const ldm::Pose& T_uav_sensor() const { return T_uav_sensor_; }
  const World& world() const { return world_; }
  /// Of the last frame, the pose as it is reported; `frame.scan` is made from these alone, and so
  /// can a log be.
  const RangeImage& range_image() const { return image_; }
  const QuaternionPose& uav_pose() const { return uav_pose_; }

 private:
  void report_pose(Frame& frame);

  double rate_;
  double pose_sigma_;
  std::uint64_t noise_seed_;
  std::int64_t frames_;
  ldm::Pose T_uav_sensor_;
  World world_;
  LidarCaster caster_;
  std::int64_t next_index_ = 0;
  QuaternionPose uav_pose_;
  RangeImage image_;
};

/// The beam pattern and noise that a scenario describes; channels are evenly spaced in elevation.
LidarModel lidar_model(const SensorDescription& sensor);

/// The sensor's pose on the UAV that a scenario describes.
ldm::Pose sensor_pose(const SensorDescription& sensor);

}  // namespace datasets
