/// The first guess of the flight path: waypoint times, the polyline, the walk around keep-outs.
#include "datasets/scenario/flight/flight_route.h"

#include <gtest/gtest.h>

#include <cmath>

#include "datasets/scenario/flight/keep_out.h"

namespace datasets {
namespace {

using Eigen::Vector3d;

FlightTask straight_task() {
  FlightTask task;
  task.duration = 12;
  task.waypoints = {{0, 0, 1}, {2, 0, 1}, {8, 0, 2}};
  return task;
}

double least_distance(const FlightTask& task, const std::vector<Vector3d>& positions, double step) {
  double least = 1e9;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const auto sample =
        static_cast<std::size_t>(std::lround(static_cast<double>(k) * step / task.sample_step));
    for (const KeepOut& keep_out : task.keep_outs) {
      least = std::min(least, signed_distance(keep_out, sample, positions[k]).value);
    }
  }
  return least;
}

TEST(FlightRoute, WaypointsAreTimedByTheDistanceAlongThePolyline) {
  FlightTask task = straight_task();
  task.waypoints = {{0, 0, 0}, {3, 0, 0}, {3, 9, 0}};
  const std::vector<TimedWaypoint> timed = time_waypoints(task);
  ASSERT_EQ(timed.size(), 3u);
  EXPECT_DOUBLE_EQ(timed[0].time, 0);
  EXPECT_DOUBLE_EQ(timed[1].time, 3);
  EXPECT_DOUBLE_EQ(timed[2].time, 12);
  EXPECT_TRUE(on_polyline(timed, 6).isApprox(Vector3d(3, 3, 0)));
  EXPECT_EQ(on_polyline(timed, -1), task.waypoints.front());
  EXPECT_EQ(on_polyline(timed, 13), task.waypoints.back());
}

TEST(FlightRoute, EqualWaypointsAreTimedEvenly) {
  FlightTask task = straight_task();
  task.waypoints.assign(4, Vector3d(1, 2, 3));
  const std::vector<TimedWaypoint> timed = time_waypoints(task);
  EXPECT_DOUBLE_EQ(timed[1].time, 4);
  EXPECT_DOUBLE_EQ(timed[2].time, 8);
  EXPECT_EQ(on_polyline(timed, 5), Vector3d(1, 2, 3));
}

TEST(FlightRoute, WithoutKeepOutsTheWalkFollowsThePolylineToTheNextCell) {
  const FlightTask task = straight_task();
  const std::vector<TimedWaypoint> waypoints = time_waypoints(task);
  const double step = 0.6, cell = task.max_speed * step / 3;
  const std::vector<Vector3d> positions = route(task, waypoints, step, 20);
  ASSERT_EQ(positions.size(), 21u);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Vector3d offset = positions[k] - on_polyline(waypoints, static_cast<double>(k) * step);
    EXPECT_LE(offset.head<2>().norm(), cell) << k;
    EXPECT_LT(std::abs(offset.z()), 1e-12) << k;
  }
}

TEST(FlightRoute, TheWalkDodgesAKeepOutThatComesHeadOnAndKeepsTheSpeedLimit) {
  FlightTask task = straight_task();
  KeepOut keep_out{.radius = 0.5, .z_min = 0, .z_max = 3, .centre = {}};
  for (int sample = 0; sample <= 120; ++sample) keep_out.centre.emplace_back(8 - 0.1 * sample, 0);
  task.keep_outs = {keep_out};
  const double step = 0.6;
  const std::vector<Vector3d> positions = route(task, time_waypoints(task), step, 20);
  EXPECT_GE(least_distance(task, positions, step), task.clearance);
  for (std::size_t k = 1; k < positions.size(); ++k) {
    const Vector3d d = positions[k] - positions[k - 1];
    EXPECT_LE(d.head<2>().norm(), task.max_speed * step + 1e-12) << k;
  }
}

TEST(FlightRoute, TheWalkGoesRoundARowOfKeepOuts) {
  FlightTask task = straight_task();
  for (const double y : {-1.5, 0.0, 1.5}) {  // no gap between them is wide enough
    task.keep_outs.push_back({.radius = 0.5,
                              .z_min = 0,
                              .z_max = 3,
                              .centre = std::vector<Eigen::Vector2d>(121, {4, y})});
  }
  const double step = 0.6;
  const std::vector<Vector3d> positions = route(task, time_waypoints(task), step, 20);
  EXPECT_GE(least_distance(task, positions, step), task.clearance);
  EXPECT_GT(positions.back().x(), 7);
}

}  // namespace
}  // namespace datasets
