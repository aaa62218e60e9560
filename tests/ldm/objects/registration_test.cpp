#include "ldm/objects/registration.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tests/ldm/objects/lidar.h"

namespace ldm {
namespace {

const Eigen::Vector3d kSensor(0, 0, 1);

View seen(const Box& box, double noise = 0) {
  NoisyLidar lidar(noise);
  return view_of(kSensor.head<2>(), lidar.returns(kSensor, {box}));
}

Box moved(Box box, double x, double y) {
  box.centre += Eigen::Vector3d(x, y, 0);
  return box;
}

TEST(Registration, OutlineOfAFlatFrontLooksAtTheSensor) {
  const Outline outline = outline_of(seen({{3, 0, 1}, {0.4, 0.4, 1}}));
  ASSERT_EQ(outline.spots.size(), outline.view.slices.size());
  for (const auto& spots : outline.spots) {
    for (const Outline::Spot& spot : spots) {
      EXPECT_NEAR(std::abs(spot.normal.x()), 1, 1e-3);
      EXPECT_NEAR(spot.point.x(), 2.8, 1e-3);
    }
  }
}

TEST(Registration, FindsTheWayOfABox) {
  const Box box{{2.5, 1, 1}, {0.3, 0.4, 1}};
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.05, 0.0}, {0.0, 0.05}, {-0.12, 0.09}}) {
    const Displacement d =
        registered(outline_of(seen(box)), seen(moved(box, x, y)), Eigen::Vector2d::Zero());
    EXPECT_NEAR(d.value.x(), x, 0.01);
    EXPECT_NEAR(d.value.y(), y, 0.01);
    EXPECT_LT(d.misfit, 1);
  }
}

TEST(Registration, ErrorIsWithinWhatItSays) {
  const Box box{{2, 0.5, 1}, {0.3, 0.3, 1}};
  NoisyLidar lidar;
  const auto look = [&](const Box& b) {
    return view_of(kSensor.head<2>(), lidar.returns(kSensor, {b}));
  };
  int within = 0;
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector2d truth(0.002 * i, 0.1 - 0.004 * i);
    const Displacement d =
        registered(outline_of(look(box)), look(moved(box, truth.x(), truth.y())), {0, 0});
    const Eigen::Vector2d error = d.value - truth;
    EXPECT_LT(error.norm(), 0.02);
    within += error.dot(d.information * error) < 9.2 ? 1 : 0;  // 99 %
  }
  EXPECT_GE(within, 38);
}

/// Of a wall whose ends are hidden nothing says how far it has gone along itself.
TEST(Registration, KnowsWhatItCannotKnow) {
  View wall = seen({{3, 0, 1}, {0.2, 2, 1}});
  for (Slice& slice : wall.slices) slice.edges = {false, false};
  const Displacement d = registered(outline_of(wall), wall, {0, 0});
  EXPECT_GT(d.information(0, 0), 1e4);
  EXPECT_LT(d.information(1, 1), 10);
}

TEST(Registration, WhatHasAnotherShapeIsUncertain) {
  const View square = seen({{2, 0, 1}, {0.4, 0.4, 1}});
  View deep = seen({{2, 0, 1}, {0.1, 0.4, 1}});
  for (Slice& slice : deep.slices) {
    // Bent to a wedge.
    for (Column& c : slice.columns) c.point.x() += std::abs(c.point.y());
  }
  const Displacement same = registered(outline_of(square), square, {0, 0});
  const Displacement other = registered(outline_of(square), deep, {0, 0});
  EXPECT_GT(other.misfit, 4 * same.misfit);
  EXPECT_LT(other.information.trace(), same.information.trace() / 10);
}

}  // namespace
}  // namespace ldm
