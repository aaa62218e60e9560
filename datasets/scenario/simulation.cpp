#include "datasets/scenario/simulation.h"

#include <Eigen/Geometry>
#include <numbers>
#include <string>

#include "datasets/random.h"

namespace datasets {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

const Scenario& checked(const Scenario& scenario) {
  check(scenario);
  return scenario;
}

std::int64_t frame_count(const Scenario& scenario, std::optional<std::int64_t> frames) {
  if (!frames) return scenario.frames;
  if (*frames < 1 || *frames > scenario.frames) {
    throw ldm::InvalidInput("frames = " + std::to_string(*frames) + ": allowed: 1 to " +
                            std::to_string(scenario.frames) + ", the frames of scenario " +
                            scenario.name);
  }
  return *frames;
}

}  // namespace

LidarModel lidar_model(const SensorDescription& sensor) {
  LidarModel model;
  const double lowest = sensor.elevation.min, highest = sensor.elevation.max;
  for (std::int64_t channel = 0; channel < sensor.channels; ++channel) {
    // A single channel looks along the middle.
    const double share = sensor.channels == 1 ? 0.5
                                              : static_cast<double>(channel) /
                                                    static_cast<double>(sensor.channels - 1);
    model.elevations.push_back((lowest + share * (highest - lowest)) * kDegree);
  }
  model.azimuths = static_cast<std::int32_t>(sensor.azimuths);
  model.rate = sensor.rate;
  model.min_range = sensor.range.min;
  model.max_range = sensor.range.max;
  model.range_sigma = sensor.range_sigma;
  return model;
}

ldm::Pose sensor_pose(const SensorDescription& sensor) {
  const Eigen::Vector3d angles = sensor.roll_pitch_yaw * kDegree;
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  return {rotation, sensor.position};
}

Simulation::Simulation(const Scenario& scenario, std::uint64_t seed,
                       std::optional<std::int64_t> frames)
    : rate_(checked(scenario).sensor.rate),
      pose_sigma_(scenario.sensor.pose_sigma),
      noise_seed_(mixed(seed)),
      frames_(frame_count(scenario, frames)),
      T_uav_sensor_(to_pose(to_quaternion_pose(sensor_pose(scenario.sensor)))),
      world_(draw_world(scenario, seed)),
      caster_(lidar_model(scenario.sensor)) {}

bool Simulation::next(Frame& frame) {
  if (next_index_ == frames_) return false;
  frame.index = next_index_++;
  frame.scan.time = static_cast<double>(frame.index) / rate_;
  uav_pose_ = to_quaternion_pose(world_.path.T_world_uav(frame.scan.time));
  frame.scan.T_world_uav = to_pose(uav_pose_);
  frame.scan.T_world_sensor = composed(frame.scan.T_world_uav, T_uav_sensor_);

  if (!frame.truth) frame.truth.emplace();
  frame.truth->objects.resize(world_.obstacles.size());
  for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
    world_.obstacles[i].state_at(frame.scan.time, frame.truth->objects[i]);
  }
  const std::uint64_t noise_key = random_bits(noise_seed_, static_cast<std::uint64_t>(frame.index));
  caster_.cast(frame.scan.T_world_sensor, frame.truth->objects, noise_key, image_,
               frame.truth->noise_free_hits);
  caster_.beams().project(image_, frame.scan);
  if (pose_sigma_ > 0) report_pose(frame);
  return true;
}

/// The scan was taken from the true pose; what is known of that is noisy.
void Simulation::report_pose(Frame& frame) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto draw = static_cast<std::uint64_t>(3 * frame.index + axis);
    uav_pose_.translation(axis) += pose_sigma_ * normal_of(random_bits(mixed(noise_seed_), draw));
  }
  frame.scan.T_world_uav = to_pose(uav_pose_);
  frame.scan.T_world_sensor = composed(frame.scan.T_world_uav, T_uav_sensor_);
}

}  // namespace datasets
