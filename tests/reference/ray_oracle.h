#pragma once
/// Oracle of ray casting (paper Sec. 3.3.2): each voxel of the map is tested against the ray.
#include <algorithm>
#include <limits>
#include <optional>

#include "ldm/types.h"

namespace reference {

/// origin + t * direction for t in [begin, end]; lengths in voxels, voxel v covers [v, v + 1).
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
  double begin = 0;
  double end = 1;
};

/// The ray from `sensor` to the centre of voxel v (t = 1), or from there on without an end.
inline Ray ray_to_centre(const Eigen::Vector3d& sensor, const ldm::VoxelIndex& v) {
  return {sensor, v.cast<double>().array() + 0.5 - sensor.array(), 0, 1};
}
inline Ray ray_behind(const Eigen::Vector3d& sensor, const ldm::VoxelIndex& v) {
  Ray ray = ray_to_centre(sensor, v);
  ray.begin = 1;
  ray.end = std::numeric_limits<double>::infinity();
  return ray;
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

/// Passage through voxel v grown by `margin` [voxels] on every side.
inline std::optional<Passage> passage(const Ray& ray, const ldm::VoxelIndex& v, double margin = 0) {
  const Eigen::Vector3d low = v.cast<double>().array() - margin;
  return passage(ray, low, low.array() + 1 + 2 * margin);
}

/// A ray that only grazes a voxel may be rounded either way.
enum class Crossing { kMissed, kGrazed, kCrossed };

/// Crossed: it meets the voxel shrunk by `tolerance` [voxels]; missed: not even the grown one.
inline Crossing crossing(const Ray& ray, const ldm::VoxelIndex& v, double tolerance = 1e-4) {
  if (passage(ray, v, -tolerance)) return Crossing::kCrossed;
  return passage(ray, v, tolerance) ? Crossing::kGrazed : Crossing::kMissed;
}

}  // namespace reference
