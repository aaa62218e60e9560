#pragma once
/// The cells of OctoMap's tree along a ray; for files of baselines/ that use liboctomap (Amanatides
/// and Woo, 1987).
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace baselines {

/// Calls cross(key) for each cell from that of `origin` on, without that of `end`: the same as
/// octomap::OcTree::computeRayKeys lists, by the same arithmetic, but in registers. There, each
/// step reads back as a whole a key that it has written in parts, which takes most of its time.
/// Requires both ends in the tree.
template <class Cross>
void for_each_crossed(const octomap::OcTree& tree, const octomap::point3d& origin,
                      const octomap::point3d& end, Cross&& cross) {
  const octomap::OcTreeKey first = tree.coordToKey(origin);
  const octomap::OcTreeKey last = tree.coordToKey(end);
  if (first == last) return;
  cross(first);

  octomap::point3d direction = end - origin;
  const auto length = static_cast<float>(direction.norm());
  direction /= length;
  int key[3], step[3];
  double leaves[3], between[3];  // along the ray [m]: to the next wall, and from wall to wall
  for (unsigned axis = 0; axis < 3; ++axis) {
    const float d = direction(axis);
    key[axis] = first[axis];
    step[axis] = (d > 0) - (d < 0);
    leaves[axis] = between[axis] = std::numeric_limits<double>::max();
    if (step[axis] == 0) continue;
    const double half = step[axis] * tree.getResolution() * 0.5;
    const double wall =
        tree.keyToCoord(first[axis]) + static_cast<double>(static_cast<float>(half));
    leaves[axis] = (wall - static_cast<double>(origin(axis))) / static_cast<double>(d);
    between[axis] = tree.getResolution() / std::fabs(static_cast<double>(d));
  }
  auto [x, y, z] = key;
  auto [leaves_x, leaves_y, leaves_z] = leaves;
  for (;;) {
    if (leaves_x < leaves_y && leaves_x < leaves_z) {
      x += step[0];
      leaves_x += between[0];
    } else if (!(leaves_x < leaves_y) && leaves_y < leaves_z) {
      y += step[1];
      leaves_y += between[1];
    } else {
      z += step[2];
      leaves_z += between[2];
    }
    if (x == last[0] && y == last[1] && z == last[2]) return;
    // Rounding may have led past the last cell.
    if (std::min({leaves_x, leaves_y, leaves_z}) > static_cast<double>(length)) return;
    cross(octomap::OcTreeKey(static_cast<octomap::key_type>(x), static_cast<octomap::key_type>(y),
                             static_cast<octomap::key_type>(z)));
  }
}

}  // namespace baselines
