#include "baselines/scan_cells.h"

namespace baselines {

ScanCells::ScanCells(int reach)
    : edge_(2 * static_cast<std::size_t>(reach) + 1), grid_(edge_ * edge_ * edge_, kUnmet) {}

void ScanCells::start(const octomap::OcTreeKey& sensor) {
  for (const octomap::OcTreeKey& key : keys_) grid_[index(key)] = kUnmet;
  keys_.clear();
  for (unsigned axis = 0; axis < 3; ++axis) {
    lowest_[axis] = static_cast<octomap::key_type>(sensor[axis] - edge_ / 2);
  }
}

void ScanCells::cross(const octomap::OcTreeKey& key) {
  std::uint8_t& cell = grid_[index(key)];
  if (cell != kUnmet) return;
  cell = kCrossed;
  keys_.push_back(key);
}

void ScanCells::hit(const octomap::OcTreeKey& key) {
  cross(key);
  grid_[index(key)] = kHit;
}

std::size_t ScanCells::index(const octomap::OcTreeKey& key) const {
  const auto from_lowest = [&](unsigned axis) {
    return std::size_t{static_cast<octomap::key_type>(key[axis] - lowest_[axis])};
  };
  return from_lowest(0) + edge_ * (from_lowest(1) + edge_ * from_lowest(2));
}

}  // namespace baselines
