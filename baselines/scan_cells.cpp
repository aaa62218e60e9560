#include "baselines/scan_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace baselines {

ScanCells::ScanCells(int reach)
    : edge_(2 * static_cast<std::size_t>(reach) + 1), grid_(edge_ * edge_ * edge_, kUnmet) {}

void ScanCells::start(const octomap::OcTreeKey& sensor) {
  std::fill(grid_.begin(), grid_.end(), kUnmet);
  for (unsigned axis = 0; axis < 3; ++axis) {
    lowest_[axis] = static_cast<octomap::key_type>(sensor[axis] - edge_ / 2);
  }
}

/// From cell to cell by their index in the grid. In OctoMap each step reads back as a whole a key
/// that it has written in parts, which takes most of its time.
///
/// What a cell held is written without a look: no ray waits for another in the same cell.
void ScanCells::cross(const octomap::OcTree& tree, const octomap::point3d& sensor,
                      const octomap::point3d& end) {
  const octomap::OcTreeKey first = tree.coordToKey(sensor);
  std::size_t cell = index(first);
  const std::size_t last = index(tree.coordToKey(end));
  if (cell == last) return;
  std::uint8_t* const grid = grid_.data();
  grid[cell] = kCrossed;

  octomap::point3d direction = end - sensor;
  const auto norm = static_cast<float>(direction.norm());
  direction /= norm;
  const auto length = static_cast<double>(norm);
  const std::size_t stride[3] = {1, edge_, edge_ * edge_};
  std::size_t step[3] = {};      // of the index; downwards it wraps, as do sums with it
  double leaves[3], between[3];  // along the ray [m]: to the next wall, and from wall to wall
  for (unsigned axis = 0; axis < 3; ++axis) {
    const float d = direction(axis);
    const int sign = (d > 0) - (d < 0);
    leaves[axis] = between[axis] = std::numeric_limits<double>::max();
    if (sign == 0) continue;
    step[axis] = sign > 0 ? stride[axis] : -stride[axis];
    const double half = sign * tree.getResolution() * 0.5;
    const double wall =
        tree.keyToCoord(first[axis]) + static_cast<double>(static_cast<float>(half));
    leaves[axis] = (wall - static_cast<double>(sensor(axis))) / static_cast<double>(d);
    between[axis] = tree.getResolution() / std::fabs(static_cast<double>(d));
  }
  auto [leaves_x, leaves_y, leaves_z] = leaves;
  for (;;) {
    if (leaves_x < leaves_y && leaves_x < leaves_z) {
      cell += step[0];
      leaves_x += between[0];
    } else if (!(leaves_x < leaves_y) && leaves_y < leaves_z) {
      cell += step[1];
      leaves_y += between[1];
    } else {
      cell += step[2];
      leaves_z += between[2];
    }
    if (cell == last) return;
    // Rounding may have led past the last cell.
    if (std::min({leaves_x, leaves_y, leaves_z}) > length) return;
    grid[cell] = kCrossed;
  }
}

}  // namespace baselines
