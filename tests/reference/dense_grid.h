#pragma once
/// Oracle of the circular buffer (paper Sec. 3.3.1): cells kept by world voxel, nothing wraps.
#include <array>
#include <map>

#include "ldm/types.h"

namespace reference {

/// A window of voxels that moves; a cell is kept while its voxel stays in the window.
template <class Cell>
class DenseGrid {
 public:
  /// `size` voxels per axis, the window centred on voxel 0.
  explicit DenseGrid(const Eigen::Vector3i& size, Cell empty = {})
      : window_{-size / 2, size}, empty_(empty) {}

  const ldm::VoxelBox& window() const { return window_; }

  /// Move the window so that its centre voxel, floor(size / 2) from the origin, is c.
  void recenter(const ldm::VoxelIndex& c) {
    window_.origin = c - window_.size / 2;
    std::erase_if(cells_, [&](const auto& cell) {
      const auto& [x, y, z] = cell.first;
      return !window_.contains(ldm::VoxelIndex(x, y, z));
    });
  }

  /// The cell of v; `empty` until it is written. Requires window().contains(v).
  Cell& at(const ldm::VoxelIndex& v) {
    return cells_.try_emplace({v.x(), v.y(), v.z()}, empty_).first->second;
  }

 private:
  ldm::VoxelBox window_;
  Cell empty_;
  std::map<std::array<int, 3>, Cell> cells_;
};

}  // namespace reference
