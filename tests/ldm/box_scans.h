#pragma once
/// Scans of boxes by a LiDAR without noise, in arithmetic that gives the same bits everywhere.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ldm/types.h"

namespace ldm {

/// An upright box, world frame [m].
struct Box {
  Eigen::Vector3d centre;
  Eigen::Vector3d size;
};

/// Unit vectors all round through a grid on the four sides of a cube: no sine, no cosine.
inline std::vector<Eigen::Vector3d> all_round(int half_columns, int half_rows) {
  std::vector<Eigen::Vector3d> directions;
  for (int z = -half_rows; z <= half_rows; ++z) {
    for (int along = -half_columns; along < half_columns; ++along) {
      for (const Eigen::Vector3i& side :
           {Eigen::Vector3i(half_columns, along, z), Eigen::Vector3i(-along, half_columns, z),
            Eigen::Vector3i(-half_columns, -along, z), Eigen::Vector3i(along, -half_columns, z)}) {
        const Eigen::Vector3d d = side.cast<double>();
        directions.push_back(d / std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z()));
      }
    }
  }
  return directions;
}

/// Distance along a ray to a box [m], if it meets it from outside.
inline std::optional<double> range_to(const Box& box, const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& direction) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.centre[axis] - box.size[axis] / 2 - origin[axis];
    const double high = box.centre[axis] + box.size[axis] / 2 - origin[axis];
    if (direction[axis] == 0) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    const auto [near, far] = std::minmax({low / direction[axis], high / direction[axis]});
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  if (enter >= leave || enter == 0) return std::nullopt;
  return enter;
}

/// What a level LiDAR at `uav` sees of the boxes.
inline Scan scan_of(const std::vector<Box>& boxes, double time, const Eigen::Vector3d& uav,
                    int half_columns = 30) {
  Scan scan;
  scan.time = time;
  scan.T_world_uav.translation = scan.T_world_sensor.translation = uav;
  for (const Eigen::Vector3d& direction : all_round(half_columns, half_columns / 3)) {
    std::optional<double> nearest;
    for (const Box& box : boxes) {
      const std::optional<double> range = range_to(box, uav, direction);
      if (range && (!nearest || *range < *nearest)) nearest = range;
    }
    if (nearest) {
      scan.points.push_back((direction * *nearest).cast<float>());
    } else {
      scan.no_returns.push_back(direction.cast<float>());
    }
  }
  return scan;
}

}  // namespace ldm
