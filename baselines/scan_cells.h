#pragma once
/// The cells of OctoMap's tree that the rays of a scan meet; for files of baselines/ that use
/// liboctomap (Hornung et al., Autonomous Robots 2013, Sec. 3.3).
#include <octomap/OcTree.h>

#include <cstdint>
#include <vector>

namespace baselines {

/// Each cell that a ray of the scan crosses or ends in, once; a cell with an end is a hit whatever
/// crosses it. The same cells as octomap::OccupancyOcTreeBase::computeUpdate collects in two hash
/// sets: a flat grid around the sensor takes a fifth of their time.
class ScanCells {
 public:
  /// @param reach from the sensor's cell to the farthest that a ray meets, along an axis [cells]
  explicit ScanCells(int reach);

  /// Forgets the cells of the scan before.
  void start(const octomap::OcTreeKey& sensor);
  /// The cells from that of `sensor` on, without that of `end`: those that
  /// octomap::OcTree::computeRayKeys lists, by the same arithmetic (Amanatides and Woo, 1987).
  /// Requires both in the tree, and within reach.
  void cross(const octomap::OcTree& tree, const octomap::point3d& sensor,
             const octomap::point3d& end);
  /// Requires that no ray of the scan crosses cells any more.
  void hit(const octomap::OcTreeKey& key) { grid_[index(key)] = kHit; }

  /// Calls visit(key, is_hit) for each cell met, x fastest.
  template <class Visit>
  void for_each(Visit&& visit) const {
    std::size_t i = 0;
    octomap::OcTreeKey end;
    for (unsigned axis = 0; axis < 3; ++axis) {
      end[axis] = static_cast<octomap::key_type>(lowest_[axis] + edge_);
    }
    octomap::OcTreeKey key = lowest_;
    for (key[2] = lowest_[2]; key[2] != end[2]; ++key[2]) {
      for (key[1] = lowest_[1]; key[1] != end[1]; ++key[1]) {
        for (key[0] = lowest_[0]; key[0] != end[0]; ++key[0], ++i) {
          if (grid_[i] != kUnmet) visit(key, grid_[i] == kHit);
        }
      }
    }
  }

 private:
  static constexpr std::uint8_t kUnmet = 0, kCrossed = 1, kHit = 2;
  std::size_t index(const octomap::OcTreeKey& key) const {
    const auto from_lowest = [&](unsigned axis) {
      return std::size_t{static_cast<octomap::key_type>(key[axis] - lowest_[axis])};
    };
    return from_lowest(0) + edge_ * (from_lowest(1) + edge_ * from_lowest(2));
  }

  std::size_t edge_;
  octomap::OcTreeKey lowest_;  // of the grid
  std::vector<std::uint8_t> grid_;
};

}  // namespace baselines
