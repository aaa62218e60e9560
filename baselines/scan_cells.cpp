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

}  // namespace baselines
