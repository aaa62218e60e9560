#pragma once
/// The ground as a grid of heights over a plane, which follows hills and dips (paper Sec. 4.2.1:
/// ground returns are ignored).
#include <cstdint>
#include <vector>

#include "datasets/recording/filter/ground_plane.h"

namespace datasets {

/// From the sensor outwards, cell after cell: the lowest point of a cell is ground if it lies no
/// farther from where its neighbours' ground goes on than the steepest slope allows; a cell
/// without such a point (behind a car, on its roof) goes on as its neighbours do.
/// Cost: one pass over the points and one over the cells, which reach 64 m far.
class GroundGrid {
 public:
  explicit GroundGrid(const GroundParameters& parameters);

  /// @param points with the sensor in the origin and z up [m]
  void fit(const GroundPlane& plane, const std::vector<ldm::Point>& points);
  /// Height of p over the ground below it [m]; beyond the grid over that of the nearest cell.
  float above(const ldm::Point& p) const;

 private:
  static constexpr float kReach = 64;  // [m]

  std::size_t cell_of(const ldm::Point& p) const;
  float of_neighbours(std::int32_t cell) const;

  float cell_, step_;
  int cells_;                           // along each axis
  std::vector<std::int32_t> outwards_;  // cells by their distance from the sensor
  std::vector<std::int32_t> rank_;      // position of each cell in `outwards_`
  GroundPlane plane_;
  std::vector<float> lowest_;  // of each cell: height of its lowest point over the plane
  std::vector<float> ground_;  // of each cell: height of the ground over the plane
};

}  // namespace datasets
