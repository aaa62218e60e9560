#pragma once
/// Oracle of ray casting (paper Sec. 3.3.2): each voxel of the map is tested against the ray.
#include <limits>
#include <optional>

#include "ldm/plain/ray.h"

namespace reference {

using ldm::plain::Passage;
using ldm::plain::passage;
using ldm::plain::Ray;
using ldm::plain::ray_to_centre;

/// The ray from the centre of voxel v on, away from `sensor`, without an end.
inline Ray ray_behind(const Eigen::Vector3d& sensor, const ldm::VoxelIndex& v) {
  Ray ray = ray_to_centre(sensor, v);
  ray.begin = 1;
  ray.end = std::numeric_limits<double>::infinity();
  return ray;
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
