#pragma once
/// The voxels of this project as keys of OctoMap's tree; for files of baselines/ that use
/// liboctomap (no paper section).
#include <octomap/OcTreeKey.h>

#include "ldm/types.h"

namespace baselines {

inline constexpr int kVoxelsToBorder = 32768;  ///< of the tree, from the origin: keys have 16 bits

/// The octree numbers its voxels from its border on. Requires coordinates within the border.
inline octomap::OcTreeKey key_of(const ldm::VoxelIndex& v) {
  const Eigen::Matrix<octomap::key_type, 3, 1> key =
      (v.array() + kVoxelsToBorder).cast<octomap::key_type>();
  return {key.x(), key.y(), key.z()};
}

inline ldm::VoxelIndex voxel_of(const octomap::OcTreeKey& key) {
  return ldm::VoxelIndex(key[0], key[1], key[2]).array() - kVoxelsToBorder;
}

}  // namespace baselines
