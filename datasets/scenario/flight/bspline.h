#pragma once
/// Uniform cubic B-spline basis: the weights that turn control points into a point of the flight
/// path (paper Sec. 4.1.1).
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace datasets {

/// Derivative of the curve with respect to time, or the curve itself.
enum class Derivative { kPosition, kVelocity, kAcceleration, kJerk };

/// The curve (or its derivative) at one time is the sum of weight[i] * control_point[first + i].
struct BasisWeights {
  std::size_t first = 0;
  std::array<double, 4> weight{};  ///< [1], [1/s], [1/s^2] or [1/s^3]
};

/// Weights at time t [s] of a curve of `segments` >= 1 segments (segments + 3 control points), each
/// `knot_step` [s] long; t is clamped to [0, segments * knot_step]. A knot belongs to the segment
/// it begins; the last one to the segment it ends.
BasisWeights basis_weights(double t, double knot_step, std::size_t segments, Derivative derivative);

/// The curve of these control points (at least 4), or its derivative, at time t [s], clamped as
/// above.
Eigen::Vector3d curve_at(const std::vector<Eigen::Vector3d>& control_points, double knot_step,
                         double t, Derivative derivative = Derivative::kPosition);

}  // namespace datasets
