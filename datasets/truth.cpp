/// The true state of the voxels around the UAV (ground truth of paper Sec. 4.1.2).
#include <algorithm>
#include <cmath>

#include "datasets/frame.h"
#include "datasets/solid_bounds.h"

namespace datasets {
namespace {

/// Voxels of the window whose centres may lie within `reach` of `centre` along each axis.
ldm::VoxelBox voxels_around(const Eigen::Vector3d& centre, const Eigen::Vector3d& reach,
                            const ldm::VoxelBox& window, double resolution) {
  const auto voxel_at = [&](const Eigen::Vector3d& p) {
    return ldm::VoxelIndex((p / resolution).array().floor().cast<int>());
  };
  const ldm::VoxelIndex first = voxel_at(centre - reach).cwiseMax(window.origin);
  const ldm::VoxelIndex last =
      voxel_at(centre + reach).cwiseMin(window.origin + window.size - ldm::VoxelIndex::Ones());
  return {first, (last - first + ldm::VoxelIndex::Ones()).cwiseMax(0)};
}

/// Give the free voxels whose centres the solid contains to its object.
void fill(const Solid& solid, std::int32_t object, const ldm::VoxelBox& window, double resolution,
          std::vector<std::int32_t>& object_of_voxel) {
  const ldm::VoxelBox box =
      voxels_around(solid.T_world_solid.translation, half_extent(solid), window, resolution);
  const ldm::VoxelIndex end = box.origin + box.size;
  for (int z = box.origin.z(); z < end.z(); ++z) {
    for (int y = box.origin.y(); y < end.y(); ++y) {
      for (int x = box.origin.x(); x < end.x(); ++x) {
        const Eigen::Vector3d centre = (Eigen::Vector3d(x, y, z).array() + 0.5) * resolution;
        std::int32_t& owner = object_of_voxel[window.index({x, y, z})];
        if (owner < 0 && solid.contains(centre)) owner = object;
      }
    }
  }
}

}  // namespace

bool Solid::contains(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d local =
      T_world_solid.rotation.transpose() * (p - T_world_solid.translation);
  const Eigen::Vector3d half = size / 2;
  switch (shape) {
    case Shape::kBox:
      return (local.cwiseAbs().array() <= half.array()).all();
    case Shape::kCylinder:
      return std::abs(local.z()) <= half.z() &&
             local.head<2>().squaredNorm() <= half.x() * half.x();
    case Shape::kSphere:
      return local.squaredNorm() <= half.x() * half.x();
  }
  return false;
}

void solid_voxels(const Truth& truth, const ldm::VoxelBox& window, double resolution,
                  std::vector<std::int32_t>& object_of_voxel) {
  object_of_voxel.assign(window.count(), -1);
  for (std::size_t i = 0; i < truth.objects.size(); ++i) {
    for (const Solid& solid : truth.objects[i].solids) {
      fill(solid, static_cast<std::int32_t>(i), window, resolution, object_of_voxel);
    }
  }
}

void visible_voxels(const Truth& truth, const ldm::VoxelBox& window, double resolution,
                    std::vector<std::uint8_t>& visible) {
  visible.assign(window.count(), 0);
  for (const ldm::Point& hit : truth.noise_free_hits) {
    const Eigen::Array3d position = (hit.cast<double>() / resolution).array().floor();
    const ldm::VoxelIndex voxel = position.cast<int>();
    if (window.contains(voxel)) visible[window.index(voxel)] = 1;
  }
}

}  // namespace datasets
