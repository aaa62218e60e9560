#pragma once
/// A ray and the boxes that it passes through: for paper Sec. 3.3.2.
#include <algorithm>
#include <optional>

#include "ldm/types.h"

namespace ldm::plain {

/// origin + t * direction for t in [begin, end]; lengths in voxels, voxel v covers [v, v + 1).
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
  double begin = 0;
  double end = 1;
};

/// The ray from `sensor` to the centre of voxel v (t = 1).
inline Ray ray_to_centre(const Eigen::Vector3d& sensor, const VoxelIndex& v) {
  return {sensor, v.cast<double>().array() + 0.5 - sensor.array(), 0, 1};
}

/// The t at which a ray enters and leaves a box.
struct Passage {
  double enter;
  double leave;
};

/// Passage through the closed box [low, high]; empty if they do not meet.
inline std::optional<Passage> passage(const Ray& ray, const Eigen::Vector3d& low,
                                      const Eigen::Vector3d& high) {
  Passage inside{ray.begin, ray.end};
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0) {
      if (o < low[axis] || o > high[axis]) return std::nullopt;
      continue;
    }
    const auto [near, far] = std::minmax({(low[axis] - o) / d, (high[axis] - o) / d});
    inside = {std::max(inside.enter, near), std::min(inside.leave, far)};
  }
  if (inside.enter > inside.leave) return std::nullopt;
  return inside;
}

}  // namespace ldm::plain
