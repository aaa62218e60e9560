#include "experiments/avoidance/planner/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "datasets/random.h"
#include "datasets/scenario/flight/bspline.h"

namespace experiments {
namespace {

using datasets::Derivative;

constexpr double kStep = 0.2;
constexpr FlightLimits kLimits{.speed = 2, .acceleration = 4};

/// Straight on along x at that speed [m/s].
ControlPoints cruising(double speed, std::size_t count) {
  ControlPoints points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(static_cast<double>(i) * speed * kStep, 0, 1.5);
  }
  return points;
}

/// At 2 m/s and 4 m/s^2 the speed falls by 0.8 m/s a knot: 1.2, 0.4, 0 m/s, which are 0.24 and
/// 0.08 m. The curve passes q[2] at the last fixed knot, and ends on the last point.
TEST(Braked, StopsInTheDistanceWorkedByHand) {
  const ControlPoints points = braked(cruising(2, 4), 12, kStep, kLimits);
  EXPECT_NEAR(points.back().x(), 3 * 0.4 + 0.24 + 0.08, 1e-12);
  const double end = 9 * kStep;
  EXPECT_NEAR(datasets::curve_at(points, kStep, end, Derivative::kVelocity).norm(), 0, 1e-12);
  // From the knot at which it begins to act, against v^2 / (2 a) = 0.5 m of a jump to full braking.
  const double braking =
      datasets::curve_at(points, kStep, end).x() - datasets::curve_at(points, kStep, kStep).x();
  EXPECT_NEAR(braking, 0.72, 1e-12);
}

TEST(Braked, StaysAtRest) {
  const ControlPoints points = braked(ControlPoints(4, {1, 2, 3}), 9, kStep, kLimits);
  ASSERT_EQ(points.size(), 9U);
  for (const Eigen::Vector3d& p : points) EXPECT_EQ(p, Eigen::Vector3d(1, 2, 3));
}

TEST(Limit, LeavesAFlyableTrajectoryAlone) {
  const ControlPoints points = cruising(1.9, 12);
  ControlPoints same = points;
  limit(same, 4, kStep, kLimits);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR((same[i] - points[i]).norm(), 0, 1e-12);
}

TEST(Limit, HoldsAtEveryInstant) {
  datasets::Random random(11);
  for (int round = 0; round < 100; ++round) {
    ControlPoints points = cruising(random.uniform(0, 2), 18);
    for (std::size_t i = 4; i < points.size(); ++i) {
      for (double& along : points[i]) along += random.uniform(-1, 1);
    }
    limit(points, 4, kStep, kLimits);
    for (double t = 0; t <= 15 * kStep; t += 0.01) {
      EXPECT_LE(datasets::curve_at(points, kStep, t, Derivative::kVelocity).norm(), 2 + 1e-9);
      EXPECT_LE(datasets::curve_at(points, kStep, t, Derivative::kAcceleration).norm(), 4 + 1e-9);
    }
  }
}

}  // namespace
}  // namespace experiments
