#pragma once
/// How far the sensor sees in each direction, and so which ends of an object are its own (no paper
/// section; docs/objects.md).
#include <Eigen/Core>
#include <span>
#include <vector>

#include "ldm/objects/view.h"

namespace ldm {

/// The nearest return in each of 2048 horizontal directions.
class Panorama {
 public:
  /// @param points all returns of a scan near the map, world [m]
  void fill(const Eigen::Vector2d& sensor, std::span<const Eigen::Vector3d> points);

  /// Horizontal distance of the nearest return in a direction [m]; infinite if there is none.
  float nearest(const Eigen::Vector2d& direction) const { return nearest_[bin(direction)]; }

  /// True if the sensor saw past p (world [m]), or nothing returned at all in that direction.
  /// Cost: constant.
  bool seen_past(const Eigen::Vector2d& p) const;

  /// Say which slices of a view from the same sensor end where the object does: at the ends of the
  /// whole, not where something nearer stands just beside.
  void mark_edges(View& view) const;

 private:
  static std::size_t bin(const Eigen::Vector2d& direction);

  Eigen::Vector2d sensor_ = Eigen::Vector2d::Zero();
  std::vector<float> nearest_;
};

}  // namespace ldm
