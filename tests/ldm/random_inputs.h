#pragma once
/// Inputs of the property tests of ldm/: map sizes, windows and voxels drawn at random.
#include <random>
#include <vector>

#include "ldm/parameters.h"
#include "ldm/types.h"

namespace ldm {

using Random = std::mt19937_64;

/// Powers of two, odd and prime numbers, the smallest size, and a different one for each axis.
inline std::vector<Eigen::Vector3i> map_sizes() {
  return {{5, 5, 5}, {7, 7, 7}, {32, 32, 32}, {33, 33, 33}, {5, 12, 33}};
}

inline MapParameters map_of(const Eigen::Vector3i& voxels, double resolution = 0.15) {
  MapParameters map;
  map.voxels = voxels;
  map.resolution = resolution;
  return map;
}

inline double uniform(double low, double high, Random& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Evenly from low..high.
inline int uniform_int(int low, int high, Random& random) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

/// Each component evenly from low..high.
inline Eigen::Vector3i random_vector(int low, int high, Random& random) {
  const int x = uniform_int(low, high, random);
  const int y = uniform_int(low, high, random);
  return {x, y, uniform_int(low, high, random)};
}

inline VoxelIndex random_voxel(const VoxelBox& box, Random& random) {
  const int x = uniform_int(0, box.size.x() - 1, random);
  const int y = uniform_int(0, box.size.y() - 1, random);
  return box.origin + VoxelIndex(x, y, uniform_int(0, box.size.z() - 1, random));
}

}  // namespace ldm
