#include "experiments/metrics/truth_grid.h"

#include <algorithm>

namespace experiments {

void TruthGrid::fill(const datasets::Truth& truth, const ldm::VoxelBox& window, double resolution) {
  window_ = window;
  padded_ = {window.origin - ldm::VoxelIndex::Ones(), window.size + ldm::VoxelIndex::Constant(2)};
  objects_ = truth.objects.size();
  datasets::solid_voxels(truth, padded_, resolution, owner_);
  datasets::visible_voxels(truth, window_, resolution, visible_);
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
