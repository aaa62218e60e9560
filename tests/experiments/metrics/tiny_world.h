#pragma once
/// Grids small enough to count by hand: voxels of 1 m, so that voxel (i, j, k) has its centre at
/// (i + 0.5, j + 0.5, k + 0.5).
#include <initializer_list>

#include "datasets/frame.h"
#include "ldm/types.h"

namespace experiments {

/// A box that holds exactly the centres of the voxels from `low` to `high`, both included.
inline datasets::ObjectState box_object(std::int32_t id, const ldm::VoxelIndex& low,
                                        const ldm::VoxelIndex& high) {
  datasets::ObjectState object;
  object.id = id;
  object.size = (high - low).cast<double>() + Eigen::Vector3d::Constant(0.5);
  object.position = 0.5 * (low + high).cast<double>() + Eigen::Vector3d::Constant(0.5);
  datasets::Solid solid;
  solid.T_world_solid.translation = object.position;
  solid.size = object.size;
  object.solids = {solid};
  return object;
}

inline ldm::Point centre(const ldm::VoxelIndex& v) {
  return v.cast<float>() + ldm::Point::Constant(0.5f);
}

/// An unknown map of size^3 voxels from the origin.
inline ldm::LocalMap unknown_map(int size) {
  ldm::LocalMap map;
  map.window.size = Eigen::Vector3i::Constant(size);
  map.resolution = 1;
  map.occupancy.assign(map.window.count(), 0.5f);
  map.labels.assign(map.window.count(), -1);
  return map;
}

/// Occupied voxels that form the map's next cluster.
inline void add_cluster(ldm::LocalMap& map, std::initializer_list<ldm::VoxelIndex> voxels) {
  for (const ldm::VoxelIndex& v : voxels) {
    map.occupancy[map.window.index(v)] = 0.9f;
    map.labels[map.window.index(v)] = static_cast<std::int32_t>(map.clusters.size());
  }
  map.clusters.emplace_back();
}

}  // namespace experiments
