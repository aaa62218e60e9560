#pragma once
/// A small simulated LiDAR for tests: axis-parallel boxes, no noise.
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/reference/ray_oracle.h"

namespace reference {

/// World frame [m].
struct Box {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
};

inline ldm::Scan scan_at(double time, const Eigen::Vector3d& position) {
  ldm::Scan scan;
  scan.time = time;
  scan.T_world_uav.translation = position;
  scan.T_world_sensor.translation = position;
  return scan;
}

/// 16 channels over +-16.6 deg, `azimuths` around; sensor and UAV at `position`, turned nowhere.
inline ldm::Scan scan_of_boxes(double time, const Eigen::Vector3d& position,
                               const std::vector<Box>& boxes, int azimuths = 256) {
  constexpr int kChannels = 16;
  constexpr double kHalfFieldOfView = 16.6 * std::numbers::pi / 180;
  ldm::Scan scan = scan_at(time, position);
  for (int i = 0; i < kChannels * azimuths; ++i) {
    const double elevation = kHalfFieldOfView * (2.0 * (i % kChannels) / (kChannels - 1) - 1);
    const double azimuth = 2 * std::numbers::pi * (i / kChannels + 0.5) / azimuths;
    const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                    std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    const Ray ray{position, direction, 0, std::numeric_limits<double>::infinity()};
    double range = ray.end;
    for (const Box& box : boxes) {
      if (const auto hit = passage(ray, box.low, box.high)) range = std::min(range, hit->enter);
    }
    if (range == ray.end) {
      scan.no_returns.push_back(direction.cast<float>());
    } else {
      scan.points.push_back((range * direction).cast<float>());
    }
  }
  return scan;
}

}  // namespace reference
