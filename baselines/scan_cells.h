#pragma once
/// The cells of OctoMap's tree that the rays of a scan meet; for files of baselines/ that use
/// liboctomap (Hornung et al., Autonomous Robots 2013, Sec. 3.3).
#include <octomap/OcTree.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace baselines {

/// Each cell that a ray of the scan crosses or ends in, once; a cell with an end is a hit whatever
/// crosses it. The same cells as octomap::OccupancyOcTreeBase::computeUpdate collects in two hash
/// sets, in a flat grid around the sensor.
///
/// Cost: memory and time for a cube of cells as wide as the reach, which is little beside the rays
/// and the tree.
class ScanCells {
 public:
  /// @param reach from the sensor's cell to the farthest that a ray meets, along an axis [cells]
  ScanCells(const octomap::OcTree& tree, int reach);

  /// Requires that the cells of the scan before were taken.
  void start(const octomap::point3d& sensor);
  /// The cells from that of the sensor on, without that of `end`: those that
  /// octomap::OcTree::computeRayKeys lists, by the same arithmetic (Amanatides and Woo, 1987).
  /// Requires `end` in the tree, and within reach.
  void cross(const octomap::point3d& end);
  /// The cell of `end`.
  void hit(const octomap::point3d& end) { hits_.push_back(index(tree_.coordToKey(end))); }

  /// Calls visit(key, is_hit) for each cell met, x fastest, and forgets them.
  template <class Visit>
  void take(Visit&& visit);

 private:
  static constexpr std::uint8_t kUnmet = 0, kCrossed = 1, kHit = 2;
  /// What is left of a ray in a cell, and what one step of it changes.
  struct Walk {
    std::size_t cell;                 // index
    std::array<std::size_t, 3> step;  // of the index; downwards it wraps, as do sums with it
    // Along the ray [m]: to the next wall of each axis, and from wall to wall.
    std::array<double, 3> leaves, between;
  };
  Walk walk_along(const octomap::point3d& direction) const;
  void cross(Walk walk, std::size_t last, double length);

  /// Index of the sensor's cell: always in the middle of the grid.
  std::size_t middle() const { return grid_.size() / 2; }
  std::size_t next_met(std::size_t i, std::size_t end) const;
  std::size_t index(const octomap::OcTreeKey& key) const {
    const auto from_lowest = [&](unsigned axis) {
      return std::size_t{static_cast<octomap::key_type>(key[axis] - lowest_[axis])};
    };
    return from_lowest(0) + edge_ * (from_lowest(1) + edge_ * from_lowest(2));
  }

  const octomap::OcTree& tree_;
  std::size_t edge_;
  octomap::point3d sensor_;
  octomap::OcTreeKey sensor_cell_, lowest_;  // of the grid
  std::vector<std::uint8_t> grid_;           // by index
  std::vector<std::size_t> hits_;            // where rays end
};

template <class Visit>
void ScanCells::take(Visit&& visit) {
  // Last, as a hit wins over all that cross its cell.
  for (const std::size_t cell : hits_) grid_[cell] = kHit;
  hits_.clear();
  octomap::OcTreeKey key = lowest_;
  std::size_t row = 0;
  for (std::size_t z = 0; z < edge_; ++z, ++key[2]) {
    key[1] = lowest_[1];
    for (std::size_t y = 0; y < edge_; ++y, ++key[1], row += edge_) {
      const std::size_t end = row + edge_;
      for (std::size_t i = next_met(row, end); i < end; i = next_met(i + 1, end)) {
        key[0] = static_cast<octomap::key_type>(lowest_[0] + (i - row));
        visit(key, grid_[i] == kHit);
        grid_[i] = kUnmet;
      }
    }
  }
}

}  // namespace baselines
