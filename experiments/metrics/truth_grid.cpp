#include "experiments/metrics/truth_grid.h"

#include <algorithm>

namespace experiments {

void TruthGrid::fill(const datasets::Truth& truth, const ldm::VoxelBox& window, double resolution) {
  window_ = window;
  padded_ = {window.origin - ldm::VoxelIndex::Ones(), window.size + ldm::VoxelIndex::Constant(2)};
  objects_ = truth.objects.size();
  datasets::solid_voxels(truth, padded_, resolution, owner_);
  datasets::visible_voxels(truth, window_, resolution, visible_);
  find_moving(truth, resolution);
}

/// Looks into the bounding boxes of the objects alone: the window has far more voxels.
void TruthGrid::find_moving(const datasets::Truth& truth, double resolution) {
  moving_.clear();
  for (std::size_t i = 0; i < objects_; ++i) {
    const datasets::ObjectState& object = truth.objects[i];
    if (!object.dynamic) continue;
    const ldm::VoxelIndex first =
        ldm::voxel_at(object.position - object.size / 2, resolution).cwiseMax(window_.origin);
    const ldm::VoxelIndex last =
        ldm::voxel_at(object.position + object.size / 2, resolution)
            .cwiseMin(window_.origin + window_.size - ldm::VoxelIndex::Ones());
    const Eigen::Vector3i size = (last - first + ldm::VoxelIndex::Ones()).cwiseMax(0);
    for_each_voxel(ldm::VoxelBox{first, size}, [&](const ldm::VoxelIndex& v, std::size_t) {
      if (owner_[padded_.index(v)] == static_cast<std::int32_t>(i)) moving_.push_back(v);
    });
  }
}

TruthGrid::Near TruthGrid::objects_near(const ldm::VoxelIndex& v) const {
  Near near;
  const ldm::VoxelBox neighbours{v - ldm::VoxelIndex::Ones(), ldm::VoxelIndex::Constant(3)};
  for_each_voxel(neighbours, [&](const ldm::VoxelIndex& n, std::size_t) {
    const std::int32_t owner = object(n);
    const auto known_end = near.objects.begin() + static_cast<std::ptrdiff_t>(near.count);
    if (owner >= 0 && std::find(near.objects.begin(), known_end, owner) == known_end) {
      near.objects[near.count++] = owner;
    }
  });
  return near;
}

}  // namespace experiments
