#include "experiments/avoidance/planner/planner_costs.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "experiments/avoidance/planner/trajectory.h"

namespace experiments {
namespace {

using datasets::BasisWeights;
using datasets::Derivative;

/// Residuals of a cost at four control points, and their derivatives by these.
template <int kRows>
struct Evaluated {
  Eigen::Matrix<double, kRows, 1> residuals;
  Eigen::Matrix<double, kRows, 12> jacobian;
};

template <int kRows>
Evaluated<kRows> evaluated(const datasets::CurveCost<kRows>& cost,
                           const std::array<Eigen::Vector3d, 4>& q) {
  // Ceres wants rows one after another; Eigen insists that a single row be row-major anyway.
  std::array<Eigen::Matrix<double, kRows, 3, Eigen::RowMajor>, 4> parts;
  const double* blocks[4];
  double* pointers[4];
  for (std::size_t i = 0; i < 4; ++i) {
    blocks[i] = q[i].data();
    pointers[i] = parts[i].data();
  }
  Evaluated<kRows> found;
  cost.Evaluate(blocks, found.residuals.data(), pointers);
  for (int i = 0; i < 4; ++i) {
    found.jacobian.template middleCols<3>(3 * i) = parts[static_cast<std::size_t>(i)];
  }
  return found;
}

/// That the derivatives are those of the residuals, by central differences.
template <int kRows>
void expect_gradient(const datasets::CurveCost<kRows>& cost, std::array<Eigen::Vector3d, 4> q) {
  const Evaluated<kRows> here = evaluated(cost, q);
  ASSERT_TRUE((here.residuals.array() != 0).all()) << "each term must count here";
  constexpr double kStep = 1e-5;
  for (int column = 0; column < 12; ++column) {
    double& coordinate = q[static_cast<std::size_t>(column / 3)][column % 3];
    const double kept = coordinate;
    coordinate = kept + kStep;
    const auto up = evaluated(cost, q).residuals;
    coordinate = kept - kStep;
    const auto down = evaluated(cost, q).residuals;
    coordinate = kept;
    EXPECT_NEAR((here.jacobian.col(column) - (up - down) / (2 * kStep)).norm(), 0, 1e-3);
  }
}

constexpr double kDt = 0.2;
const std::array<Eigen::Vector3d, 4> kBent = {
    Eigen::Vector3d(0.9, 1.2, 1.6), {1.0, 1.3, 1.7}, {1.1, 1.25, 1.8}, {1.2, 1.2, 1.9}};

/// A wall of voxels at x in [0, 0.15) and a box of half edges 0.5 around (0, 3, 1.5).
Surroundings wall_and_box() {
  Surroundings around;
  const ldm::VoxelBox window{{0, -20, 0}, {20, 40, 20}};
  std::vector<std::uint8_t> occupied(window.count());
  for (std::size_t i = 0; i < window.count(); ++i) occupied[i] = window.voxel(i).x() == 0 ? 1 : 0;
  around.still.build(window, 0.15, occupied);
  around.movers = {{{0.5, 0.5, 0.5}, {{2, 2, 1.5}}, {0}}};
  return around;
}

TEST(SampleCost, IsTheDepthTimesItsScale) {
  const Surroundings around = wall_and_box();
  const BasisWeights basis = datasets::basis_weights(0.1, kDt, 1, Derivative::kPosition);
  const SampleCost cost(basis, around, 0, 0.8, {1, 2}, 3);
  const auto at = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(evaluated(cost, {p, p, p, p}).residuals);
  };
  // 0.5 m from the centres of the wall, 0.925 m from the box, within the band.
  EXPECT_NEAR((at({0.575, 2, 1.5}) - Eigen::Vector3d(3 * 0.3, 0, 0)).norm(), 0, 1e-5);
  // 1.125 m from the wall, 0.3 m from the box, 0.25 m above the band.
  EXPECT_NEAR((at({1.2, 2, 1.8}) - Eigen::Vector3d(0, 3 * 0.5, 0)).norm(), 0, 1e-5);
  EXPECT_NEAR((at({1.2, -2, 2.25}) - Eigen::Vector3d(0, 0, 3 * 0.25)).norm(), 0, 1e-5);
  EXPECT_NEAR((at({1.2, -2, 0.75}) - Eigen::Vector3d(0, 0, -3 * 0.25)).norm(), 0, 1e-5);
}

TEST(SampleCost, HasTheGradientOfItsValue) {
  const Surroundings around = wall_and_box();
  const BasisWeights basis = datasets::basis_weights(0.07, kDt, 1, Derivative::kPosition);
  expect_gradient(SampleCost(basis, around, 0, 1.4, {1, 1.6}, 3), kBent);
}

/// Halfway along a segment a cubic B-spline weighs its points by 1, 23, 23, 1 of 48.
TEST(TargetCost, IsTheOffsetTimesItsScale) {
  const BasisWeights basis = datasets::basis_weights(kDt / 2, kDt, 1, Derivative::kPosition);
  const Eigen::Vector3d target(1, 2, 3), scale(2, 3, 4);
  const datasets::TargetCost cost(basis, target, scale);
  const Eigen::Vector3d p = (kBent[0] + 23 * kBent[1] + 23 * kBent[2] + kBent[3]) / 48;
  EXPECT_NEAR((evaluated(cost, kBent).residuals - scale.cwiseProduct(p - target)).norm(), 0, 1e-12);
  expect_gradient(cost, kBent);
}

/// The same of acceleration, there (q0 - q1 - q2 + q3) / (2 dt^2), and of jerk,
/// (q3 - 3 q2 + 3 q1 - q0) / dt^3.
TEST(TargetCost, OfAccelerationAndJerk) {
  const auto at_middle = [](Derivative derivative) {
    return evaluated(datasets::TargetCost(datasets::basis_weights(kDt / 2, kDt, 1, derivative),
                                          Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()),
                     kBent)
        .residuals;
  };
  const auto& q = kBent;
  const Eigen::Vector3d acceleration = (q[0] - q[1] - q[2] + q[3]) / (2 * kDt * kDt);
  const Eigen::Vector3d jerk = (q[3] - 3 * q[2] + 3 * q[1] - q[0]) / (kDt * kDt * kDt);
  EXPECT_NEAR((at_middle(Derivative::kAcceleration) - acceleration).norm(), 0, 1e-9);
  EXPECT_NEAR((at_middle(Derivative::kJerk) - jerk).norm(), 0, 1e-9);
  // Acceleration is linear in time: the integral of its square is Simpson's sum, and what the
  // planner takes for it.
  const ControlPoints points(q.begin(), q.end());
  const auto squared = [&](double t) {
    return datasets::curve_at(points, kDt, t, Derivative::kAcceleration).squaredNorm();
  };
  EXPECT_NEAR(kDt * acceleration.squaredNorm() + kDt * kDt * kDt / 12 * jerk.squaredNorm(),
              kDt / 6 * (squared(0) + 4 * squared(kDt / 2) + squared(kDt)), 1e-9);
}

/// Points 0.5 m apart along x: 2.5 m/s, 0.5 above the limit; the corner is rounded by 0.05.
TEST(NormLimitCost, IsTheExcessTimesItsScale) {
  const BasisWeights basis = datasets::basis_weights(kDt / 2, kDt, 1, Derivative::kVelocity);
  const auto cost = [&](double limit) { return datasets::NormLimitCost(basis, limit, 3); };
  const std::array<Eigen::Vector3d, 4> q = {
      Eigen::Vector3d(0, 0, 1), {0.5, 0, 1}, {1, 0, 1}, {1.5, 0, 1}};
  EXPECT_NEAR(evaluated(cost(2), q).residuals[0], 3 * (0.5 + std::hypot(0.5, 0.05)) / 2, 1e-9);
  EXPECT_NEAR(evaluated(cost(2.5), q).residuals[0], 3 * 0.05 / 2, 1e-9);
  EXPECT_LT(evaluated(cost(5), q).residuals[0], 0.001) << "far below the limit it is nothing";
  expect_gradient(cost(0.5), kBent);
}

}  // namespace
}  // namespace experiments
