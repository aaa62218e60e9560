#include "experiments/avoidance/planner/trajectory.h"

namespace experiments {
namespace {

/// v, or the vector of its direction that is `longest` long.
Eigen::Vector3d shortened(const Eigen::Vector3d& v, double longest) {
  const double length = v.norm();
  return length > longest ? Eigen::Vector3d(v * (longest / length)) : v;
}

}  // namespace

void limit(ControlPoints& points, std::size_t fixed, double knot_step, const FlightLimits& limits) {
  const double longest = limits.speed * knot_step;
  const double change = limits.acceleration * knot_step * knot_step;
  Eigen::Vector3d last = points[fixed - 1], step = last - points[fixed - 2];
  for (std::size_t i = fixed; i < points.size(); ++i) {
    const Eigen::Vector3d wanted = points[i] - last;
    last = points[i];
    // Cutting to the speed takes the step nearer to the one before, which keeps it: the change of
    // both stays within its limit.
    step = shortened(step + shortened(wanted - step, change), longest);
    points[i] = points[i - 1] + step;
  }
}

ControlPoints braked(const ControlPoints& fixed, std::size_t count, double knot_step,
                     const FlightLimits& limits) {
  ControlPoints points = fixed;
  points.resize(count, fixed.back());
  limit(points, fixed.size(), knot_step, limits);
  return points;
}

}  // namespace experiments
