#include "datasets/scenario/flight/bspline.h"

#include <algorithm>

namespace datasets {
namespace {

/// Weights in terms of u in [0, 1] along a segment of unit length: the matrix form of the uniform
/// cubic B-spline (K. Qin, General matrix representations for B-splines, 1998), differentiated.
std::array<double, 4> unit_weights(double u, Derivative derivative) {
  const double s = 1 - u;
  switch (derivative) {
    case Derivative::kPosition:
      return {s * s * s / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
              (3 * s * s * s - 6 * s * s + 4) / 6, u * u * u / 6};
    case Derivative::kVelocity:
      return {-s * s / 2, (3 * u * u - 4 * u) / 2, -(3 * s * s - 4 * s) / 2, u * u / 2};
    case Derivative::kAcceleration:
      return {s, 3 * u - 2, 3 * s - 2, u};
    case Derivative::kJerk:
      break;
  }
  return {-1, 3, -3, 1};
}

}  // namespace

BasisWeights basis_weights(double t, double knot_step, std::size_t segments,
                           Derivative derivative) {
  const double count = static_cast<double>(segments);
  const double knots = std::clamp(t / knot_step, 0.0, count);
  const auto first = static_cast<std::size_t>(std::min(knots, count - 1));
  BasisWeights weights{first, unit_weights(knots - static_cast<double>(first), derivative)};
  for (int order = static_cast<int>(derivative); order > 0; --order) {
    for (double& w : weights.weight) w /= knot_step;
  }
  return weights;
}

Eigen::Vector3d curve_at(const std::vector<Eigen::Vector3d>& control_points, double knot_step,
                         double t, Derivative derivative) {
  const BasisWeights basis = basis_weights(t, knot_step, control_points.size() - 3, derivative);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < basis.weight.size(); ++i) {
    sum += basis.weight[i] * control_points[basis.first + i];
  }
  return sum;
}

}  // namespace datasets
