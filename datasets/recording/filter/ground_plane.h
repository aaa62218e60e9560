#pragma once
/// The ground under a sensor as one plane (paper Sec. 4.2.1: ground returns are ignored).
#include <optional>
#include <vector>

#include "datasets/recording/scans/input_parameters.h"
#include "ldm/types.h"

namespace datasets {

/// z = slope_x x + slope_y y + height, in a frame whose z axis points up [m].
struct GroundPlane {
  float slope_x = 0, slope_y = 0, height = 0;
  float at(float x, float y) const { return slope_x * x + slope_y * y + height; }
  float above(const ldm::Point& p) const { return p.z() - at(p.x(), p.y()); }
};

/// The plane that most of the lowest points lie on: of every cell around the sensor the lowest
/// point, among them a random search for the plane with most within 0.15 m (Fischler and Bolles,
/// 1981), then least squares. Roads may slope up to `max_slope`, and it adapts frame by frame. The
/// same points give the same bits.
/// Cost: one pass over the points.
class GroundPlaneFit {
 public:
  explicit GroundPlaneFit(const GroundParameters& parameters);

  /// @param points with the sensor in the origin and z up [m]
  /// @return none if fewer than ten cells, or less than a quarter of those with points, agree
  ///   on a plane below the sensor
  std::optional<GroundPlane> fit(const std::vector<ldm::Point>& points);

 private:
  void find_lowest(const std::vector<ldm::Point>& points);
  GroundPlane search() const;

  float radius_, cell_, steepest_;
  int cells_;  // along each axis
  std::vector<ldm::Point> lowest_of_cell_;
  std::vector<int> count_of_cell_;
  std::vector<ldm::Point> lowest_;
};

}  // namespace datasets
