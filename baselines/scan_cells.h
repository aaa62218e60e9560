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
  void cross(const octomap::OcTreeKey& key) {
    std::uint8_t& cell = grid_[index(key)];
    if (cell != kUnmet) return;
    cell = kCrossed;
    keys_.push_back(key);
  }
  void hit(const octomap::OcTreeKey& key) {
    cross(key);
    grid_[index(key)] = kHit;
  }

  /// In the order in which the rays met them first.
  const std::vector<octomap::OcTreeKey>& keys() const { return keys_; }
  bool is_hit(const octomap::OcTreeKey& key) const { return grid_[index(key)] == kHit; }

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
  std::vector<octomap::OcTreeKey> keys_;
};

}  // namespace baselines
