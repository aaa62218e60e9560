#pragma once
/// Flyable B-splines: limits that hold at every instant, and braking (closed loop after [11] of the
/// paper).
///
/// A trajectory is a uniform cubic B-spline. The speed control points (q[i + 1] - q[i]) / dt bound
/// its speed, since it never leaves their hull; its acceleration is linear between knots, where it
/// is the difference of two of them over dt. Both limits therefore hold at every instant if they
/// hold for the differences of the control points.
#include <vector>

#include "ldm/types.h"

namespace experiments {

using ControlPoints = std::vector<Eigen::Vector3d>;  ///< world [m]

struct FlightLimits {
  double speed = 2;         ///< [m/s]
  double acceleration = 4;  ///< [m/s^2]
};

/// The trajectory with its differences cut to the limits, one after another from the first that is
/// free on; what is within the limits stays.
/// @param fixed control points that stay, at least 3, within the limits themselves
void limit(ControlPoints& points, std::size_t fixed, double knot_step, const FlightLimits& limits);

/// `count` control points that begin with `fixed` (at least 3), and come to rest as soon as the
/// limit of acceleration allows, straight on.
ControlPoints braked(const ControlPoints& fixed, std::size_t count, double knot_step,
                     const FlightLimits& limits);

}  // namespace experiments
