#include "experiments/avoidance/planner/surroundings.h"

#include <gtest/gtest.h>

#include "datasets/random.h"

namespace experiments {
namespace {

TEST(BoxDistance, IsWhatGeometrySays) {
  const Eigen::Vector3d half(1, 2, 3);
  EXPECT_DOUBLE_EQ(box_distance({4, 0, 0}, half).value, 3);
  EXPECT_DOUBLE_EQ(box_distance({4, -6, 0}, half).value, 5);        // 3, 4 beyond an edge
  EXPECT_DOUBLE_EQ(box_distance({0.5, 1.8, 0}, half).value, -0.2);  // nearest face: y
  EXPECT_EQ(box_distance({4, -6, 0}, half).gradient, Eigen::Vector3d(0.6, -0.8, 0));
  EXPECT_EQ(box_distance({0.5, -1.8, 0}, half).gradient, Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(box_distance({0, 0, 0}, Eigen::Vector3d::Ones()).gradient, Eigen::Vector3d::UnitX());
}

TEST(BoxDistance, HasTheGradientOfItsValue) {
  datasets::Random random(7);
  const Eigen::Vector3d half(0.3, 0.2, 0.9);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3d p;
    for (double& along : p) along = random.uniform(-2, 2);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      const double slope =
          (box_distance(p + step, half).value - box_distance(p - step, half).value) / (2 * kStep);
      EXPECT_NEAR(box_distance(p, half).gradient[axis], slope, 1e-4);
    }
  }
}

TEST(Surroundings, TakesTheNearestMoverAtTheSample) {
  Surroundings around;
  around.margin = 0.1;
  around.movers = {{{0.5, 0.5, 0.5}, {{2, 0, 0}, {1, 0, 0}}, {0, 0.2}},
                   {{0.5, 0.5, 0.5}, {{0, 1.5, 0}, {0, 9, 0}}, {0, 0}}};
  EXPECT_NEAR(around.from_moving(0, Eigen::Vector3d::Zero()).value, 1 - 0.1, 1e-12);
  EXPECT_NEAR(around.from_moving(1, Eigen::Vector3d::Zero()).value, 0.5 - 0.2 - 0.1, 1e-12);
  EXPECT_EQ(around.from_moving(1, {0, -50, 0}).value, Surroundings::kReach);
}

}  // namespace
}  // namespace experiments
