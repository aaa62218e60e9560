/// The flight path: the spline against closed forms, the fit against its limits.
#include "datasets/scenario/flight/flight_path.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "datasets/scenario/flight/keep_out.h"

namespace datasets {
namespace {

using Eigen::Vector3d;

/// Control points on a line: the spline reproduces straight motion at constant velocity.
FlightPath straight_path(const Vector3d& start, const Vector3d& velocity) {
  std::vector<Vector3d> control_points;
  const double knot_step = 0.5;
  for (int i = -1; i <= 9; ++i) control_points.push_back(start + i * knot_step * velocity);
  return {control_points, knot_step};  // lasts 8 segments = 4 s
}

FlightPath random_path(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  std::vector<Vector3d> control_points(12);
  for (Vector3d& p : control_points) {
    p = {coordinate(generator), coordinate(generator), coordinate(generator)};
  }
  return {control_points, 0.7};
}

/// A cylinder that moves along a line at constant velocity, for tasks of 30 s.
KeepOut moving_keep_out(const Eigen::Vector2d& start, const Eigen::Vector2d& velocity) {
  KeepOut keep_out{.radius = 0.4, .z_min = 0, .z_max = 1.8, .centre = {}};
  for (int sample = 0; sample <= 300; ++sample) {
    keep_out.centre.push_back(start + 0.1 * sample * velocity);
  }
  return keep_out;
}

FlightTask crossing_task() {
  FlightTask task;
  task.duration = 30;
  task.waypoints = {{0, 0, 1.2}, {8, 0, 1.4}, {8, 8, 1.2}, {0, 8, 1}};
  task.keep_outs = {moving_keep_out({8, 0}, {-0.3, 0}),       // head-on along the first leg
                    moving_keep_out({8, 4}, {0, 0}),          // stands on the second leg
                    moving_keep_out({-4, 9.5}, {0.5, -0.1}),  // along the last leg
                    moving_keep_out({4, -6}, {0, 1})};        // crosses the first and the last leg
  return task;
}

std::string failure_of(const FlightTask& task) {
  try {
    fit_flight_path(task);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(FlightPath, StraightLineIsReproducedAtEveryTime) {
  const Vector3d start(1, -2, 3), velocity(0.5, 0.25, -0.1);
  const FlightPath path = straight_path(start, velocity);
  for (double t = 0; t <= 4; t += 0.05) {
    EXPECT_TRUE(path.position(t).isApprox(start + t * velocity, 1e-12)) << t;
    EXPECT_TRUE(path.velocity(t).isApprox(velocity, 1e-12)) << t;
    EXPECT_LT(path.acceleration(t).norm(), 1e-12) << t;
  }
}

TEST(FlightPath, KnotIsTheWeightedMeanOfThreeControlPoints) {
  const FlightPath path({{6, 0, 0}, {0, 6, 0}, {0, 0, 6}, {60, 60, 60}, {0, 0, 0}}, 2);
  // Weights 1/6, 4/6, 1/6 at a knot; velocity (c2 - c0) / 2h, acceleration (c0 - 2 c1 + c2) / h^2.
  EXPECT_TRUE(path.position(0).isApprox(Vector3d(1, 4, 1)));
  EXPECT_TRUE(path.velocity(0).isApprox(Vector3d(-1.5, 0, 1.5)));
  EXPECT_TRUE(path.acceleration(0).isApprox(Vector3d(1.5, -3, 1.5)));
  EXPECT_TRUE(path.position(4).isApprox(Vector3d(40, 40, 41)));
}

TEST(FlightPath, TimeIsClampedToTheDuration) {
  const FlightPath path = random_path(1);
  const double duration = 9 * 0.7;
  EXPECT_EQ(path.position(-1), path.position(0));
  EXPECT_EQ(path.position(duration + 1), path.position(duration));
  EXPECT_EQ(path.T_world_uav(duration + 1).rotation, path.T_world_uav(duration).rotation);
}

TEST(FlightPath, DerivativesMatchFiniteDifferencesAndAreContinuous) {
  const FlightPath path = random_path(2);
  const double h = 1e-5;
  for (double t = 0.01; t < 6.29; t += 0.01) {  // some of these straddle a knot
    const Vector3d velocity = (path.position(t + h) - path.position(t - h)) / (2 * h);
    const Vector3d acceleration = (path.velocity(t + h) - path.velocity(t - h)) / (2 * h);
    EXPECT_LT((path.velocity(t) - velocity).norm(), 1e-3) << t;
    EXPECT_LT((path.acceleration(t) - acceleration).norm(), 1e-3) << t;
  }
}

TEST(FlightPath, NeedsFourControlPointsAndAPositiveStep) {
  EXPECT_THROW(FlightPath({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0.5), ldm::InvalidInput);
  EXPECT_THROW(FlightPath(std::vector<Vector3d>(4, Vector3d::Zero()), 0), ldm::InvalidInput);
}

TEST(FlightPath, AttitudeOfLevelFlightIsTheYawOfTheMotion) {
  const ldm::Pose pose = straight_path({0, 0, 1}, {0.3, 0.3, 0}).T_world_uav(2);
  const double c = std::numbers::sqrt2 / 2;
  Eigen::Matrix3d expected;
  expected << c, -c, 0, c, c, 0, 0, 0, 1;
  EXPECT_TRUE(pose.rotation.isApprox(expected, 1e-9)) << pose.rotation;
  EXPECT_TRUE(pose.translation.isApprox(Vector3d(0.6, 0.6, 1), 1e-12));
}

TEST(FlightPath, AttitudeIsARotationWithThrustAlongAccelerationMinusGravity) {
  const FlightPath path = random_path(3);
  for (double t = 0; t <= 6.3; t += 0.07) {
    const Eigen::Matrix3d R = path.T_world_uav(t).rotation;
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12) << t;
    EXPECT_NEAR(R.determinant(), 1, 1e-12) << t;
    const Vector3d thrust = path.acceleration(t) + Vector3d(0, 0, 9.81);
    EXPECT_LT(R.col(2).cross(thrust.normalized()).norm(), 1e-12) << t;
  }
}

TEST(FlightPath, AttitudeStaysDefinedInHoverAndTurnsSmoothlyAtAReversal) {
  const FlightPath hover(std::vector<Vector3d>(8, Vector3d(1, 2, 3)), 0.5);
  EXPECT_TRUE(hover.T_world_uav(1).rotation.isApprox(Eigen::Matrix3d::Identity()));

  std::vector<Vector3d> there_and_back;
  for (int i = 0; i <= 20; ++i) there_and_back.emplace_back(i < 10 ? i : 20 - i, 0.02 * i, 1);
  const FlightPath path(there_and_back, 1);
  double largest_turn = 0;
  for (double t = 0; t + 0.01 <= 18; t += 0.01) {
    const Eigen::Matrix3d turn =
        path.T_world_uav(t).rotation.transpose() * path.T_world_uav(t + 0.01).rotation;
    largest_turn = std::max(largest_turn, Eigen::AngleAxisd(turn).angle());
  }
  EXPECT_LT(largest_turn, 0.05);                         // [rad] in 10 ms
  EXPECT_GT(path.T_world_uav(7).rotation(0, 0), 0.9);    // nose along +x on the way out
  EXPECT_LT(path.T_world_uav(18).rotation(0, 0), -0.9);  // and along -x on the way back
}

TEST(KeepOut, DistanceBesideAboveAtTheEdgeAndInside) {
  const KeepOut keep_out{.radius = 1, .z_min = 0, .z_max = 2, .centre = {{10, 0}}};
  const auto distance = [&](const Vector3d& p) { return signed_distance(keep_out, 0, p).value; };
  EXPECT_DOUBLE_EQ(distance({13, 0, 1}), 2);
  EXPECT_DOUBLE_EQ(distance({10, 0.5, 3}), 1);
  EXPECT_DOUBLE_EQ(distance({10, 0.5, -3}), 3);
  EXPECT_DOUBLE_EQ(distance({14, 0, 6}), 5);  // 3, 4, 5
  EXPECT_DOUBLE_EQ(distance({10.75, 0, 1}), -0.25);
  EXPECT_DOUBLE_EQ(distance({10, 0, 1.75}), -0.25);
  EXPECT_EQ(signed_distance(keep_out, 0, {10, 0, 1}).gradient, Vector3d::UnitX());
}

TEST(KeepOut, GradientMatchesFiniteDifferences) {
  const KeepOut keep_out{.radius = 1, .z_min = 0, .z_max = 2, .centre = {{0.1, -0.2}}};
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  const double h = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Vector3d p(coordinate(generator), coordinate(generator), coordinate(generator));
    const SignedDistance distance = signed_distance(keep_out, 0, p);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = h * Vector3d::Unit(axis);
      const double difference = signed_distance(keep_out, 0, p + step).value -
                                signed_distance(keep_out, 0, p - step).value;
      EXPECT_NEAR(distance.gradient[axis], difference / (2 * h), 1e-4) << p.transpose();
    }
  }
}

TEST(FitFlightPath, WithoutKeepOutsItPassesTheWaypoints) {
  FlightTask task = crossing_task();
  task.keep_outs.clear();
  const FlightPath path = fit_flight_path(task);
  EXPECT_LT((path.position(0) - task.waypoints[0]).norm(), 0.2);
  EXPECT_LT((path.position(10) - task.waypoints[1]).norm(), 0.2);
  EXPECT_LT((path.position(20) - task.waypoints[2]).norm(), 0.2);
  EXPECT_LT((path.position(30) - task.waypoints[3]).norm(), 0.2);
}

TEST(FitFlightPath, KeepsLimitsAndClearanceBetweenTheSamplesToo) {
  const FlightTask task = crossing_task();
  const FlightPath path = fit_flight_path(task);
  for (double t = 0; t <= 30; t += 0.01) {
    EXPECT_LE(path.velocity(t).norm(), task.max_speed) << t;
    EXPECT_LE(path.acceleration(t).norm(), task.max_acceleration) << t;
  }
  for (std::size_t sample = 0; sample <= 300; ++sample) {
    const Vector3d p = path.position(0.1 * static_cast<double>(sample));
    for (const KeepOut& keep_out : task.keep_outs) {
      EXPECT_GE(signed_distance(keep_out, sample, p).value, task.clearance) << sample;
    }
  }
}

TEST(FitFlightPath, HoversWhereAllWaypointsAreOne) {
  FlightTask task;
  task.duration = 10;
  task.waypoints = {{1, 2, 3}, {1, 2, 3}};
  const FlightPath path = fit_flight_path(task);
  for (double t = 0; t <= 10; t += 0.5) {
    EXPECT_LT((path.position(t) - task.waypoints[0]).norm(), 0.02) << t;
  }
}

TEST(FitFlightPath, SameTaskSameBits) {
  const FlightPath a = fit_flight_path(crossing_task()), b = fit_flight_path(crossing_task());
  for (double t = 0; t <= 30; t += 0.1) {
    EXPECT_EQ(a.position(t), b.position(t)) << t;
    EXPECT_EQ(a.T_world_uav(t).rotation, b.T_world_uav(t).rotation) << t;
  }
}

TEST(FitFlightPath, ImpossibleTasksNameTheBrokenLimit) {
  FlightTask far = crossing_task();
  far.waypoints.back() = {0, 500, 1};
  EXPECT_NE(failure_of(far).find("flight path breaks max_speed: "), std::string::npos)
      << failure_of(far);

  FlightTask sluggish = crossing_task();
  sluggish.max_acceleration = 0.02;
  EXPECT_NE(failure_of(sluggish).find("flight path breaks max_acceleration: "), std::string::npos)
      << failure_of(sluggish);

  FlightTask walled_out = crossing_task();  // all waypoints lie inside a keep-out
  walled_out.keep_outs = {moving_keep_out({4, 4}, {0, 0})};
  walled_out.keep_outs[0].radius = 10;
  walled_out.keep_outs[0].z_min = -50;
  walled_out.keep_outs[0].z_max = 50;
  EXPECT_NE(failure_of(walled_out).find("flight path breaks waypoint_radius: "), std::string::npos)
      << failure_of(walled_out);

  FlightTask between_walls = crossing_task();  // the walls overlap by a metre
  between_walls.waypoints = {{4, 0, 1}, {4, 8, 1}};
  between_walls.keep_outs = {moving_keep_out({-995.5, 4}, {0, 0}),
                             moving_keep_out({1003.5, 4}, {0, 0})};
  for (KeepOut& wall : between_walls.keep_outs) {
    wall.radius = 1000;
    wall.z_min = -1000;
    wall.z_max = 1000;
  }
  EXPECT_NE(failure_of(between_walls).find("flight path breaks clearance: "), std::string::npos)
      << failure_of(between_walls);
}

TEST(FitFlightPath, RejectsBadTasksByNameOfTheField) {
  const auto rejects = [](FlightTask task, const std::string& field) {
    try {
      fit_flight_path(task);
    } catch (const ldm::InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
      return true;
    }
    return false;
  };
  FlightTask task = crossing_task();
  task.waypoints.resize(1);
  EXPECT_TRUE(rejects(task, "waypoints"));
  task = crossing_task();
  task.duration = 0;
  EXPECT_TRUE(rejects(task, "duration"));
  task = crossing_task();
  task.max_acceleration = 10;
  EXPECT_TRUE(rejects(task, "max_acceleration"));
  task = crossing_task();
  task.keep_outs[1].centre.pop_back();
  EXPECT_TRUE(rejects(task, "centre"));
}

}  // namespace
}  // namespace datasets
