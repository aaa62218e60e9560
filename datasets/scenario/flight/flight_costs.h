#pragma once
/// Terms of the flight path's fit as Ceres cost functions of four neighbouring control points
/// (paper Sec. 4.1.1).
#include <ceres/sized_cost_function.h>

#include <cmath>
#include <cstddef>

#include "datasets/scenario/flight/bspline.h"
#include "datasets/scenario/flight/keep_out.h"

namespace datasets {

/// A residual of the curve, or of its derivative, at one time: both are linear in the control
/// points.
template <int kResiduals>
class CurveCost : public ceres::SizedCostFunction<kResiduals, 3, 3, 3, 3> {
 public:
  using Residual = Eigen::Matrix<double, kResiduals, 1>;
  using Gradient = Eigen::Matrix<double, kResiduals, 3>;

  explicit CurveCost(const BasisWeights& basis) : basis_(basis) {}

  bool Evaluate(double const* const* control_points, double* residuals,
                double** jacobians) const final {
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      value += basis_.weight[i] * Eigen::Map<const Eigen::Vector3d>(control_points[i]);
    }
    Residual residual;
    Gradient gradient;
    residual_of(value, residual, gradient);
    Eigen::Map<Residual>{residuals} = residual;
    for (std::size_t i = 0; jacobians != nullptr && i < 4; ++i) {
      if (jacobians[i] == nullptr) continue;
      // Ceres wants rows one after another; Eigen insists that a single row be row-major anyway.
      Eigen::Map<Eigen::Matrix<double, kResiduals, 3, Eigen::RowMajor>>{jacobians[i]} =
          basis_.weight[i] * gradient;
    }
    return true;
  }

 private:
  virtual void residual_of(const Eigen::Vector3d& value, Residual& residual,
                           Gradient& gradient) const = 0;

  BasisWeights basis_;
};

/// scale * (value - target): smoothness, waypoints, altitude.
class TargetCost final : public CurveCost<3> {
 public:
  TargetCost(const BasisWeights& basis, const Eigen::Vector3d& target, const Eigen::Vector3d& scale)
      : CurveCost(basis), target_(target), scale_(scale) {}

 private:
  void residual_of(const Eigen::Vector3d& value, Residual& residual,
                   Gradient& gradient) const override {
    residual = scale_.cwiseProduct(value - target_);
    gradient = scale_.asDiagonal();
  }

  Eigen::Vector3d target_, scale_;
};

/// Smooth form of max(x, 0), with its slope: a sharp corner would hide every limit from the solver
/// until it is broken. x in [m], [m/s] or [m/s^2].
struct SoftExcess {
  static constexpr double kWidth = 0.05;  // of the corner, in the unit of x

  explicit SoftExcess(double x) {
    const double root = std::sqrt(x * x + kWidth * kWidth);
    value = (x + root) / 2;
    slope = value / root;
  }

  double value = 0, slope = 0;
};

/// scale * the excess of |value| over the limit: speed and acceleration.
class NormLimitCost final : public CurveCost<1> {
 public:
  NormLimitCost(const BasisWeights& basis, double limit, double scale)
      : CurveCost(basis), limit_(limit), scale_(scale) {}

 private:
  void residual_of(const Eigen::Vector3d& value, Residual& residual,
                   Gradient& gradient) const override {
    const double norm = value.norm();
    const SoftExcess excess(norm - limit_);
    residual[0] = scale_ * excess.value;
    gradient.setZero();
    if (norm > 0) gradient = scale_ * excess.slope / norm * value.transpose();
  }

  double limit_, scale_;
};

/// Depth in the keep-outs widened by `clearance`, at one sample: its square is scale^2 times the
/// sum of the squared depths. One residual for all keep-outs, since few reach the UAV at a time.
class ClearanceCost final : public CurveCost<1> {
 public:
  /// `task` must outlive the cost.
  ClearanceCost(const BasisWeights& basis, const FlightTask& task, std::size_t sample,
                double clearance, double scale)
      : CurveCost(basis), task_(task), sample_(sample), clearance_(clearance), scale_(scale) {}

 private:
  void residual_of(const Eigen::Vector3d& value, Residual& residual,
                   Gradient& gradient) const override {
    double sum = 0;
    gradient.setZero();
    for (const KeepOut& keep_out : task_.keep_outs) {
      const SignedDistance distance = signed_distance(keep_out, sample_, value);
      const SoftExcess depth(clearance_ - distance.value);
      sum += depth.value * depth.value;
      gradient -= depth.value * depth.slope * distance.gradient.transpose();
    }
    const double root = std::sqrt(sum);
    residual[0] = scale_ * root;
    if (root > 0) gradient *= scale_ / root;
  }

  const FlightTask& task_;
  std::size_t sample_;
  double clearance_, scale_;
};

}  // namespace datasets
