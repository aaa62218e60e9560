#include "ldm/objects/object_tracker.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <functional>
#include <random>

#include "tests/ldm/objects/lidar.h"

namespace ldm {
namespace {

constexpr double kReach = 0.15;
const Eigen::Vector3d kSensor(0, 0, 1);

Box person(double x, double y) {
  return {{x, y, 1}, {0.3, 0.4, 1.6}};
}

/// Objects that are followed at 10 Hz.
class ObjectTrackerTest : public testing::Test {
 protected:
  void see(const std::vector<Box>& boxes) {
    tracker_.update(0.1 * frame_++, kSensor, lidar_.returns(kSensor, boxes));
  }
  /// The object most of whose returns of the last scan are in the box; null if there is none.
  const TrackedObject* at(const Box& box) const {
    const TrackedObject* best = nullptr;
    std::ptrdiff_t most = 0;
    for (const TrackedObject& object : tracker_.objects()) {
      if (object.seen() < 0.1 * (frame_ - 1) - 1e-9) continue;
      const auto inside = [&](const Eigen::Vector3d& p) {
        return ((p - box.centre).cwiseAbs().array() < box.size.array() / 2 + 0.1).all();
      };
      const auto n = std::count_if(object.points().begin(), object.points().end(), inside);
      if (n <= most) continue;
      most = n;
      best = &object;
    }
    return best;
  }
  std::int64_t id(const Box& box) const {
    const TrackedObject* object = at(box);
    return object == nullptr ? 0 : object->id();
  }

  /// The same from a pose that is `error` off [m].
  void see_displaced(const std::vector<Box>& boxes, const Eigen::Vector3d& error) {
    std::vector<Eigen::Vector3d> points = lidar_.returns(kSensor, boxes);
    for (Eigen::Vector3d& p : points) p += error;
    tracker_.update(0.1 * frame_++, kSensor + error, points);
  }

  NoisyLidar lidar_;
  ObjectTracker tracker_{kReach};
  int frame_ = 0;
};

TEST_F(ObjectTrackerTest, WhatStandsIsStatic) {
  for (int i = 0; i < 30; ++i) see({person(2, 1)});
  ASSERT_EQ(tracker_.objects().size(), 1u);
  EXPECT_LT(tracker_.objects()[0].velocity().norm(), 0.02);
  EXPECT_FALSE(tracker_.objects()[0].dynamic());
  EXPECT_EQ(tracker_.objects()[0].views(), 30);
}

/// 20 mm of noise of the pose are 0.3 m/s from scan to scan, but all objects share them.
TEST_F(ObjectTrackerTest, NoiseOfThePoseIsNoMotion) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.02);
  double walker = 0, pillar = 0;
  for (int i = 0; i < 60; ++i) {
    const Box moving = person(2.5, -3 + 0.1 * i), standing = person(-2, 1);
    see_displaced({moving, standing, person(-1, -2)}, {noise(random), noise(random), 0});
    if (i < 20) continue;
    walker = std::max(walker, (at(moving)->velocity() - Eigen::Vector2d(0, 1)).norm());
    pillar = std::max(pillar, at(standing)->velocity().norm());
  }
  EXPECT_LT(walker, 0.15);
  EXPECT_LT(pillar, 0.05);
}

TEST_F(ObjectTrackerTest, WalkersAreMeasuredToCentimetresASecond) {
  double sum = 0;
  for (int i = 0; i < 40; ++i) {
    see({person(2.5, -2 + 0.1 * i)});
    if (i < 10) continue;
    EXPECT_TRUE(tracker_.objects()[0].dynamic());
    sum += (tracker_.objects()[0].velocity() - Eigen::Vector2d(0, 1)).norm() / 30;
  }
  EXPECT_EQ(tracker_.objects().size(), 1u);
  EXPECT_LT(sum, 0.05);
}

/// 15 m/s at 10 Hz: ten voxels of 0.15 m a scan.
TEST_F(ObjectTrackerTest, NothingIsTooFast) {
  tracker_ = ObjectTracker(0.3);  // as far off its columns are 0.25 m apart
  const auto car = [](int i) { return Box{{-12 + 1.5 * i, 4, 1}, {4, 1.6, 1.4}}; };
  for (int i = 0; i < 16; ++i) {
    see({car(i)});
    if (i < 3) continue;
    const TrackedObject* object = at(car(i));
    ASSERT_NE(object, nullptr);
    EXPECT_EQ(object->id(), 1);
    EXPECT_TRUE(object->dynamic());
    EXPECT_NEAR(object->velocity().x(), 15, 1);
    EXPECT_NEAR(object->velocity().y(), 0, 1);
  }
}

/// The part of a wall that is seen through a gap slides along it while the vehicle passes.
TEST_F(ObjectTrackerTest, AWallSeenThroughAGapDoesNotMove) {
  const std::vector<Box> boxes{
      {{2, -2.65, 1}, {0.1, 4.7, 2}}, {{2, 2.65, 1}, {0.1, 4.7, 2}}, {{6, 0, 1}, {0.1, 20, 2}}};
  double fastest = 0;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d sensor(0, -2 + 0.2 * i, 1);
    tracker_.update(0.1 * i, sensor, lidar_.returns(sensor, boxes));
    for (const TrackedObject& object : tracker_.objects()) {
      EXPECT_FALSE(object.dynamic()) << i << ' ' << object.position().transpose();
      if (object.views() >= 5) fastest = std::max(fastest, object.velocity().norm());
    }
  }
  EXPECT_GT(fastest, 2);  // its outline does
}

/// A car that comes out from behind another that drives by: at first they are one segment.
TEST_F(ObjectTrackerTest, WhatMovesLeavesBehindWhatStandsBesideIt) {
  tracker_ = ObjectTracker(0.3);
  const auto driving = [](int i) { return Box{{-7 + 0.6 * i, 5, 1}, {4, 1.6, 1.4}}; };
  const Box parked{{1, 6.9, 1}, {4, 1.6, 1.4}};
  std::int64_t before = 0;
  for (int i = 0; i < 28; ++i) {
    see(i < 20 ? std::vector{driving(i)} : std::vector{driving(i), parked});
    if (i == 19) before = id(driving(i));
  }
  ASSERT_NE(at(driving(27)), nullptr);
  ASSERT_NE(at(parked), nullptr);
  EXPECT_EQ(id(driving(27)), before);
  EXPECT_TRUE(at(driving(27))->dynamic());
  EXPECT_NEAR(at(driving(27))->velocity().x(), 6, 1);
  EXPECT_NE(id(parked), before);
  EXPECT_FALSE(at(parked)->dynamic());
}

/// Away from the sensor all places ahead are hidden: it is gone from where it stood.
TEST_F(ObjectTrackerTest, WhatGoesStraightAwayMoves) {
  for (int i = 0; i < 12; ++i) see({person(1.5 + 0.1 * i, 0)});
  ASSERT_EQ(tracker_.objects().size(), 1u);
  EXPECT_TRUE(tracker_.objects()[0].dynamic());
}

/// 0.2 m/s: no faster than an ellipse of 99.9 % is wide.
TEST_F(ObjectTrackerTest, WhatIsSlowMovesAfterThreeSeconds) {
  for (int i = 0; i < 80; ++i) {
    see({person(2.5, -0.8 + 0.02 * i)});
    if (i < 30) continue;
    EXPECT_TRUE(tracker_.objects()[0].dynamic()) << i;
  }
}

TEST_F(ObjectTrackerTest, WhatStopsIsStaticAgain) {
  for (int i = 0; i < 40; ++i) see({person(2, -1 + 0.1 * std::min(i, 15))});
  ASSERT_EQ(tracker_.objects().size(), 1u);
  EXPECT_FALSE(tracker_.objects()[0].dynamic());
}

/// At 1 Hz the memory counts in scans.
TEST_F(ObjectTrackerTest, KeepsTheNumberOfWhatASlowLogMisses) {
  for (int k = 0; k < 5; ++k) tracker_.update(k, kSensor, lidar_.returns(kSensor, {person(2, 0)}));
  tracker_.update(8, kSensor, {});
  tracker_.update(10, kSensor, lidar_.returns(kSensor, {person(2, 0)}));
  ASSERT_EQ(tracker_.objects().size(), 1u);
  EXPECT_EQ(tracker_.objects()[0].id(), 1);
}

TEST_F(ObjectTrackerTest, KeepsItsNumberBehindAnother) {
  const Box pillar{{1.5, 0, 1}, {0.4, 0.6, 2}};
  const auto walker = [](int i) { return person(3, -2 + 0.1 * i); };
  int hidden = 0;
  std::int64_t before = 0;
  for (int i = 0; i < 45; ++i) {
    see({pillar, walker(i)});
    if (i == 5) before = id(walker(i));
    hidden += id(walker(i)) == 0 ? 1 : 0;
  }
  EXPECT_GE(hidden, 3);
  EXPECT_NE(before, 0);
  EXPECT_EQ(id(walker(44)), before);
}

/// A post that passes hides one end of a box, then its middle, then the other end.
TEST_F(ObjectTrackerTest, WhatIsHiddenInPartHasOneNumber) {
  const Box box{{2.5, 0, 1}, {0.3, 0.8, 1.6}};
  for (int i = 0; i < 60; ++i) {
    see({box, {{1, -0.9 + 0.03 * i, 1}, {0.2, 0.2, 2}}});
    EXPECT_EQ(tracker_.objects().size(), 2u) << i;
  }
}

/// Both are within half a metre: at first each could have moved to where the other is.
TEST_F(ObjectTrackerTest, NeighboursAreNotTakenForOneAtFirst) {
  for (int i = 0; i < 3; ++i) see({person(2, 0), person(2, 0.9)});
  EXPECT_EQ(tracker_.objects().size(), 2u);
  EXPECT_NE(id(person(2, 0)), id(person(2, 0.9)));
}

/// Apart for 8 scans, then one thing for longer.
TEST_F(ObjectTrackerTest, PartsThatStayTogetherBecomeOne) {
  const Box left{{2, 0.37, 1}, {0.3, 0.3, 1.6}}, right{{2, -0.37, 1}, {0.3, 0.3, 1.6}};
  const Box between{{2, 0, 1}, {0.3, 0.5, 1.6}};
  for (int i = 0; i < 8; ++i) see({left, right});
  EXPECT_EQ(tracker_.objects().size(), 2u);
  for (int i = 0; i < 8; ++i) see({left, between, right});
  EXPECT_EQ(tracker_.objects().size(), 2u);
  for (int i = 0; i < 3; ++i) see({left, between, right});
  EXPECT_EQ(tracker_.objects().size(), 1u);
}

TEST_F(ObjectTrackerTest, TwoThatMeetAndPartKeepTheirNumbers) {
  // Side by side they are one segment.
  const auto first = [](int i) { return person(2.5, -1.5 + 0.1 * i); };
  const auto second = [](int i) { return person(2.9, 1.5 - 0.1 * i); };
  std::int64_t one = 0, other = 0;
  for (int i = 0; i < 31; ++i) {
    see({first(i), second(i)});
    if (i != 5) continue;
    one = id(first(i));
    other = id(second(i));
  }
  EXPECT_NE(one, other);
  EXPECT_EQ(id(first(30)), one);
  EXPECT_EQ(id(second(30)), other);
}

TEST_F(ObjectTrackerTest, WhatLeavesIsForgottenAndItsNumberNotUsedAgain) {
  for (int i = 0; i < 20; ++i) see({person(2, 0)});
  for (int i = 0; i < 39; ++i) see({});
  EXPECT_EQ(tracker_.objects().size(), 1u);
  for (int i = 0; i < 3; ++i) see({});
  EXPECT_TRUE(tracker_.objects().empty());
  see({person(2, 0)});
  ASSERT_EQ(tracker_.objects().size(), 1u);
  EXPECT_EQ(tracker_.objects()[0].id(), 2);
}

/// Over walks of several directions: neither boastful nor shy.
TEST_F(ObjectTrackerTest, EllipseOfTheVelocityHoldsTheTruth) {
  int held = 0, all = 0;
  for (int walk = 0; walk < 6; ++walk) {
    tracker_ = ObjectTracker(kReach);
    const Eigen::Vector2d v(0.2 * walk - 0.5, 1 - 0.15 * walk);
    for (int i = 0; i < 35; ++i) {
      const Eigen::Vector2d place = Eigen::Vector2d(2.5, -1) + 0.1 * i * v;
      see({person(place.x(), place.y())});
      if (i < 10) continue;
      const TrackedObject& object = tracker_.objects().at(0);
      const Eigen::Vector2d error = object.velocity() - v;
      held += error.dot(object.velocity_covariance().inverse() * error) < 5.99 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GE(held, 0.9 * all);
}

}  // namespace
}  // namespace ldm
