/// Obstacles: speed profiles against their closed form, and bodies of the drawn size.
#include "datasets/scenario/obstacle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "datasets/solid_bounds.h"
#include "tests/datasets/scenario/random_solids.h"

namespace datasets {
namespace {

ObstacleGroup shuttles() {
  return {.name = "shuttles",
          .count = 1,
          .shape = ObstacleShape::kPerson,
          .motion = ObstacleMotionKind::kShuttle,
          .width = {0.4, 0.6},
          .height = {1.5, 1.9},
          .bottom = {0, 0.5},
          .legs = {1, 3},
          .leg = {1, 4},
          .speed = {0.3, 1.5},
          .acceleration = {0.5, 2},
          .pause = {0.2, 1},
          .stride = {0.9, 1.3}};
}

ObstacleGroup walkers() {
  ObstacleGroup group = shuttles();
  group.shape = ObstacleShape::kWalker;
  return group;
}

TEST(ObstacleMotionTest, TrapezoidalLeg) {
  // 1 s up to 2 m/s, 2 s at 2 m/s, 1 s down: 1 + 4 + 1 = 6 m.
  const Leg leg{.start = 10,
                .from = {1, 2},
                .direction = {0, 1},
                .length = 6,
                .top_speed = 2,
                .acceleration = 2,
                .pause = 1};
  EXPECT_DOUBLE_EQ(leg.ramp_time(), 1);
  EXPECT_DOUBLE_EQ(leg.travel_time(), 4);
  const ObstacleMotion motion({leg});
  const auto along = [&](double t) { return motion.at(t).position.y() - 2; };
  EXPECT_DOUBLE_EQ(along(9), 0);
  EXPECT_DOUBLE_EQ(along(10.5), 0.25);
  EXPECT_DOUBLE_EQ(along(11), 1);
  EXPECT_DOUBLE_EQ(along(12), 3);
  EXPECT_DOUBLE_EQ(along(13.5), 5.75);
  EXPECT_DOUBLE_EQ(along(14), 6);
  EXPECT_DOUBLE_EQ(along(99), 6);
  EXPECT_EQ(motion.at(12).velocity, Eigen::Vector2d(0, 2));
  EXPECT_EQ(motion.at(13.5).velocity, Eigen::Vector2d(0, 1));
  EXPECT_EQ(motion.at(10.5).acceleration, Eigen::Vector2d(0, 2));
  EXPECT_EQ(motion.at(12).acceleration, Eigen::Vector2d(0, 0));
  EXPECT_EQ(motion.at(13.5).acceleration, Eigen::Vector2d(0, -2));
  EXPECT_EQ(motion.at(99).velocity, Eigen::Vector2d(0, 0));
  EXPECT_EQ(motion.at(9).velocity, Eigen::Vector2d(0, 0));
}

TEST(ObstacleMotionTest, ShortLegNeverReachesTopSpeed) {
  const Leg leg{.length = 1, .top_speed = 5, .acceleration = 1};
  EXPECT_DOUBLE_EQ(leg.ramp_time(), 1);
  EXPECT_DOUBLE_EQ(leg.travel_time(), 2);
  EXPECT_DOUBLE_EQ(ObstacleMotion({leg}).at(1).position.x(), 0.5);
}

TEST(ObstacleMotionTest, TurnsDuringThePause) {
  const Leg there{.length = 1, .top_speed = 1, .acceleration = 1, .pause = 2};
  Leg back{.start = 4,
           .from = {1, 0},
           .direction = {0, 1},
           .length = 1,
           .top_speed = 1,
           .acceleration = 1};
  const ObstacleMotion motion({there, back});
  EXPECT_DOUBLE_EQ(motion.at(1).heading, 0);
  EXPECT_DOUBLE_EQ(motion.at(3).heading, std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(motion.at(4).heading, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(motion.at(5).heading, std::numbers::pi / 2);
}

TEST(ObstacleMotionTest, DrawnShuttlesKeepTheirLimits) {
  const ObstacleGroup group = shuttles();
  Random random(23);
  for (int i = 0; i < 50; ++i) {
    const ObstacleMotion motion = draw_motion(group, {10, 8}, 1, 60, random);
    EXPECT_FALSE(motion.is_static());
    MotionState last = motion.at(0);
    double travelled = 0;
    for (int k = 1; k <= 6000; ++k) {
      const MotionState now = motion.at(0.01 * k);
      EXPECT_LE(now.velocity.norm(), 1.5 + 1e-9);
      EXPECT_LE(now.acceleration.norm(), 2 + 1e-9);
      // Velocity and position are the integrals of what they should be.
      EXPECT_LE((now.velocity - last.velocity).norm(), 2 * 0.01 + 1e-9);
      EXPECT_LE((now.position - last.position - 0.005 * (now.velocity + last.velocity)).norm(),
                2 * 0.01 * 0.01);
      travelled += (now.position - last.position).norm();
      last = now;
    }
    EXPECT_GT(travelled, 60 * 0.1);
  }
}

TEST(ObstacleMotionTest, ShuttlesComeBack) {
  ObstacleGroup group = shuttles();
  group.legs = {2, 2};
  Random random(29);
  const ObstacleMotion motion = draw_motion(group, {10, 10}, 1, 300, random);
  const Eigen::Vector2d start = motion.at(-100).position;
  int visits = 0;
  bool away = false;
  for (double t = 0; t < 300; t += 0.05) {
    const bool near = (motion.at(t).position - start).norm() < 1e-9;
    visits += near && away;
    away = !near;
  }
  EXPECT_GE(visits, 2);
}

TEST(ObstacleMotionTest, SpeedScaleSpeedsUp) {
  const ObstacleGroup group = shuttles();
  const auto fastest = [&](double scale) {
    Random random(31);
    const ObstacleMotion motion = draw_motion(group, {10, 10}, scale, 60, random);
    double speed = 0;
    for (double t = 0; t < 60; t += 0.05) speed = std::max(speed, motion.at(t).velocity.norm());
    return speed;
  };
  EXPECT_GT(fastest(2), 1.5 * fastest(1));
  EXPECT_LE(fastest(2), 3 + 1e-9);
}

TEST(ObstacleBodyTest, PersonsHaveTheDrawnSize) {
  Random random(37);
  for (int i = 0; i < 20; ++i) {
    const ObstacleBody body = draw_body(shuttles(), random);
    ASSERT_EQ(body.solids.size(), 4u);
    Eigen::Vector3d top = Eigen::Vector3d::Constant(-9), bottom = -top;
    for (const Solid& solid : body.solids) {
      top = top.cwiseMax(solid.T_world_solid.translation + half_extent(solid));
      bottom = bottom.cwiseMin(solid.T_world_solid.translation - half_extent(solid));
    }
    EXPECT_NEAR(top.z(), body.height / 2, 1e-12);
    EXPECT_NEAR(bottom.z(), -body.height / 2, 1e-12);
    EXPECT_GE(top.y() - bottom.y(), 0.4);
    EXPECT_LE(top.y() - bottom.y(), 0.6);
    EXPECT_LT(top.x() - bottom.x(), top.y() - bottom.y()) << "broader than deep";
  }
}

TEST(ObstacleBodyTest, TheRadiusHoldsEveryPoint) {
  Random random(41);
  for (const auto shape : {ObstacleShape::kBox, ObstacleShape::kCylinder, ObstacleShape::kPerson}) {
    ObstacleGroup group = shuttles();
    group.shape = shape;
    const ObstacleBody body = draw_body(group, random);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Eigen::Vector3d point = random_vector(1, random);
      for (const Solid& solid : body.solids) {
        if (!solid.contains(point)) continue;
        ++inside;
        EXPECT_LE(point.head<2>().norm(), body.radius + 1e-12);
        EXPECT_LE(std::abs(point.z()), body.height / 2 + 1e-12);
      }
    }
    EXPECT_GT(inside, 100);
  }
}

TEST(ObstacleTest, StateIsTheTruthOfItsSolids) {
  Random random(43);
  const ObstacleGroup group = shuttles();
  ObstacleMotion motion = draw_motion(group, {10, 10}, 1, 60, random);
  const Obstacle obstacle{7, draw_body(group, random), 0.25, std::move(motion)};
  ObjectState state;
  for (const double t : {0.0, 12.34, 59.0}) {
    obstacle.state_at(t, state);
    EXPECT_EQ(state.id, 7);
    EXPECT_TRUE(state.dynamic);
    EXPECT_EQ(state.velocity.z(), 0);
    EXPECT_EQ(state.acceleration.z(), 0);
    EXPECT_NEAR(state.position.z() - state.size.z() / 2, 0.25, 1e-12);
    const MotionState moved = obstacle.motion.at(t);
    EXPECT_EQ(state.position.head<2>(), moved.position);
    if (moved.velocity.norm() > 0) {
      const Eigen::Vector3d forward = state.solids[0].T_world_solid.rotation.col(0);
      EXPECT_NEAR(forward.head<2>().dot(moved.velocity.normalized()), 1, 1e-12) << "faces its way";
    }
    for (const Solid& solid : state.solids) {
      const Eigen::Vector3d offset = solid.T_world_solid.translation - state.position;
      const Eigen::Vector3d reach = offset.cwiseAbs() + half_extent(solid);
      EXPECT_TRUE((reach.array() <= state.size.array() / 2 + 1e-12).all());
    }
  }
}

/// Lowest point of a leg of `state`, seen along the way the walker faces [m].
double foot_ahead(const ObjectState& state, std::size_t leg) {
  const ldm::Pose& pose = state.solids[leg].T_world_solid;
  const Eigen::Vector3d foot = pose * Eigen::Vector3d(0, 0, -state.solids[leg].size.z() / 2);
  return (foot - state.position).dot(state.solids[0].T_world_solid.rotation.col(0));
}

TEST(WalkerTest, LegsSwingWithTheWayWalked) {
  Random random(53);
  const Leg way{.length = 20, .top_speed = 1, .acceleration = 1};
  const Obstacle walker{0, draw_body(walkers(), random), 0, ObstacleMotion({way})};
  const Gait& gait = *walker.body.gait;
  ObjectState state, later;
  const double reach = walker.body.solids[gait.left_leg].size.z() * std::sin(gait.widest);
  double farthest = 0;
  for (double t = 2; t < 12; t += 0.05) {
    walker.state_at(t, state);
    walker.state_at(t + gait.stride / 1.0, later);  // at 1 m/s a stride later
    EXPECT_NEAR(foot_ahead(state, gait.left_leg), -foot_ahead(state, gait.right_leg), 1e-9);
    EXPECT_NEAR(foot_ahead(state, gait.left_leg), foot_ahead(later, gait.left_leg), 1e-9);
    farthest = std::max(farthest, foot_ahead(state, gait.left_leg));
    EXPECT_EQ(state.velocity, Eigen::Vector3d(1, 0, 0)) << "that of the body";
  }
  EXPECT_NEAR(farthest, reach, 0.01 * reach);
}

TEST(WalkerTest, StandsUprightAtRest) {
  Random random(59);
  const Leg way{.length = 2, .top_speed = 1, .acceleration = 1};
  const Obstacle walker{0, draw_body(walkers(), random), 0, ObstacleMotion({way})};
  ObjectState state;
  for (const double t : {-1.0, 3.0, 9.0}) {
    walker.state_at(t, state);
    EXPECT_NEAR(foot_ahead(state, walker.body.gait->left_leg), 0, 1e-9) << t;
  }
}

TEST(WalkerTest, TheRadiusHoldsTheSwingingLegs) {
  Random random(61);
  const Leg way{.length = 20, .top_speed = 1, .acceleration = 1};
  for (int i = 0; i < 20; ++i) {
    const Obstacle walker{0, draw_body(walkers(), random), 0, ObstacleMotion({way})};
    ObjectState state;
    for (double t = 0; t < 4; t += 0.1) {
      walker.state_at(t, state);
      for (int k = 0; k < 300; ++k) {
        const Eigen::Vector3d point = state.position + random_vector(1, random);
        for (const Solid& solid : state.solids) {
          if (!solid.contains(point)) continue;
          EXPECT_LE((point - state.position).head<2>().norm(), walker.body.radius + 1e-12);
          EXPECT_TRUE(((point - state.position).array().abs() <= state.size.array() / 2).all());
        }
      }
    }
  }
}

}  // namespace
}  // namespace datasets
