#pragma once
/// Oracle of clustering (paper Sec. 3.5): connected components by comparing voxels pair by pair.
#include <cstddef>
#include <vector>

#include "ldm/types.h"

namespace reference {

/// True if a and b are equal or touch, corners included.
inline bool are_neighbours(const ldm::VoxelIndex& a, const ldm::VoxelIndex& b) {
  return (a - b).cwiseAbs().maxCoeff() <= 1;
}

/// Per voxel the number of its 26-connected component; components are numbered by their first
/// voxel in the order given. Cost: O(N^2) comparisons.
inline std::vector<int> components(const std::vector<ldm::VoxelIndex>& voxels) {
  std::vector<int> component(voxels.size(), -1);
  int count = 0;
  for (std::size_t first = 0; first < voxels.size(); ++first) {
    if (component[first] >= 0) continue;
    component[first] = count;
    std::vector<std::size_t> to_visit{first};
    while (!to_visit.empty()) {
      const std::size_t i = to_visit.back();
      to_visit.pop_back();
      for (std::size_t j = 0; j < voxels.size(); ++j) {
        if (component[j] >= 0 || !are_neighbours(voxels[i], voxels[j])) continue;
        component[j] = count;
        to_visit.push_back(j);
      }
    }
    ++count;
  }
  return component;
}

}  // namespace reference
