#pragma once
/// Walking through the voxels of a box.
#include "ldm/types.h"

namespace reference {

/// The voxel at `index` of a box: the inverse of VoxelBox::index.
inline ldm::VoxelIndex voxel_of(const ldm::VoxelBox& box, std::size_t index) {
  const auto i = static_cast<int>(index);
  const int nx = box.size.x();
  const int ny = box.size.y();
  return box.origin + ldm::VoxelIndex(i % nx, i / nx % ny, i / nx / ny);
}

/// Calls visit(v) for each voxel of a box, in the order of VoxelBox::index.
template <class Visit>
void for_each_voxel(const ldm::VoxelBox& box, Visit&& visit) {
  for (std::size_t i = 0; i < box.count(); ++i) visit(voxel_of(box, i));
}

}  // namespace reference
