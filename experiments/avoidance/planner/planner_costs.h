#pragma once
/// Terms of the planner as Ceres cost functions of four neighbouring control points (closed loop
/// after [11] of the paper). Ceres minimises half of the squared residuals.
#include <algorithm>

#include "datasets/scenario/flight/flight_costs.h"
#include "experiments/avoidance/planner/surroundings.h"

namespace experiments {

/// Heights between which the UAV is to stay, world z [m].
struct HeightBand {
  double lowest = 0.9, highest = 2.1;
};

/// What keeps one sample of the trajectory off obstacles: scale * depth below the wanted distance
/// from what stands and from what moves, and scale * distance out of the height band.
class SampleCost final : public datasets::CurveCost<3> {
 public:
  /// @param wanted distance of the UAV's centre from anything [m]
  /// `surroundings` must outlive the cost.
  SampleCost(const datasets::BasisWeights& basis, const Surroundings& surroundings,
             std::size_t sample, double wanted, const HeightBand& band, double scale)
      : CurveCost(basis),
        surroundings_(surroundings),
        sample_(sample),
        wanted_(wanted),
        band_(band),
        scale_(scale) {}

 private:
  void residual_of(const Eigen::Vector3d& p, Residual& residual,
                   Gradient& gradient) const override {
    residual.setZero();
    gradient.setZero();
    const auto keep_off = [&](int row, const Distance& distance) {
      if (distance.value >= wanted_) return;
      residual[row] = scale_ * (wanted_ - distance.value);
      gradient.row(row) = -scale_ * distance.gradient.transpose();
    };
    keep_off(0, surroundings_.from_still(p));
    keep_off(1, surroundings_.from_moving(sample_, p));
    const double out = p.z() - std::clamp(p.z(), band_.lowest, band_.highest);
    residual[2] = scale_ * out;
    if (out != 0) gradient(2, 2) = scale_;
  }

  const Surroundings& surroundings_;
  std::size_t sample_;
  double wanted_;
  HeightBand band_;
  double scale_;
};

}  // namespace experiments
