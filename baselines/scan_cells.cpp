#include "baselines/scan_cells.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace baselines {

ScanCells::ScanCells(const octomap::OcTree& tree, int reach)
    : tree_(tree),
      edge_(2 * static_cast<std::size_t>(reach) + 1),
      grid_(edge_ * edge_ * edge_, kUnmet) {}

void ScanCells::start(const octomap::point3d& sensor) {
  sensor_ = sensor;
  sensor_cell_ = tree_.coordToKey(sensor);
  for (unsigned axis = 0; axis < 3; ++axis) {
    lowest_[axis] = static_cast<octomap::key_type>(sensor_cell_[axis] - edge_ / 2);
  }
}

void ScanCells::cross(const octomap::point3d& end) {
  const std::size_t last = index(tree_.coordToKey(end));
  if (last == middle()) return;
  grid_[middle()] = kCrossed;
  octomap::point3d direction = end - sensor_;
  const auto length = static_cast<float>(direction.norm());
  if (length == 0) return;  // on both sides of a wall, and too close to have a direction
  direction /= length;
  cross(walk_along(direction), last, static_cast<double>(length));
}

ScanCells::Walk ScanCells::walk_along(const octomap::point3d& direction) const {
  Walk walk{middle(), {}, {}, {}};
  std::size_t stride = 1;
  for (unsigned axis = 0; axis < 3; ++axis, stride *= edge_) {
    const float d = direction(axis);
    const int sign = (d > 0) - (d < 0);
    walk.leaves[axis] = walk.between[axis] = std::numeric_limits<double>::max();
    if (sign == 0) continue;
    walk.step[axis] = sign > 0 ? stride : -stride;
    const double half = sign * tree_.getResolution() * 0.5;
    const double wall =
        tree_.keyToCoord(sensor_cell_[axis]) + static_cast<double>(static_cast<float>(half));
    walk.leaves[axis] = (wall - static_cast<double>(sensor_(axis))) / static_cast<double>(d);
    walk.between[axis] = tree_.getResolution() / std::fabs(static_cast<double>(d));
  }
  return walk;
}

/// By the index of a cell: in OctoMap each step reads back as a whole a key that it has written in
/// parts, which takes most of its time. Cells are overwritten unread, so no ray waits for another.
void ScanCells::cross(Walk walk, std::size_t last, double length) {
  std::uint8_t* const grid = grid_.data();
  auto [cell, step, leaves, between] = walk;
  auto [x, y, z] = leaves;
  for (;;) {
    if (x < y && x < z) {
      cell += step[0];
      x += between[0];
    } else if (!(x < y) && y < z) {
      cell += step[1];
      y += between[1];
    } else {
      cell += step[2];
      z += between[2];
    }
    if (cell == last) return;
    if (std::min({x, y, z}) > length) return;  // rounding has led past the last cell
    grid[cell] = kCrossed;
  }
}

/// The first of cells [i, end) that a ray met, or `end`. Most are not: eight at a time.
std::size_t ScanCells::next_met(std::size_t i, std::size_t end) const {
  std::uint64_t eight = 0;
  for (; i + sizeof eight <= end; i += sizeof eight) {
    std::memcpy(&eight, &grid_[i], sizeof eight);
    if (eight != 0) break;
  }
  while (i < end && grid_[i] == kUnmet) ++i;
  return i;
}

}  // namespace baselines
