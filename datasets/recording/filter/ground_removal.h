#pragma once
/// Which points of a scan are ground (paper Sec. 4.2.1: ground returns are ignored).
#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/recording/filter/ground_grid.h"
#include "datasets/recording/filter/ground_plane.h"

namespace datasets {

class GroundFinder {
 public:
  /// Requires that `parameters.removal` is not kNone.
  explicit GroundFinder(const GroundParameters& parameters);

  /// Marks the points that lie less than `margin` above the ground, or below it, with 1.
  /// @return false, with no point marked, if no ground can be made out
  bool mark(const ldm::Scan& scan, std::vector<std::uint8_t>& is_ground);

 private:
  GroundParameters parameters_;
  GroundPlaneFit plane_fit_;
  std::optional<GroundGrid> grid_;    // if the ground is one
  std::vector<ldm::Point> levelled_;  // sensor in the origin, axes of the world
};

}  // namespace datasets
