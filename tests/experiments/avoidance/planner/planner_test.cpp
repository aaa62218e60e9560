#include "experiments/avoidance/planner/planner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace experiments {
namespace {

constexpr double kEdge = 0.15;

/// Flies from (-4, 0, 1.5) to (6, 0, 1.5) past what `is_occupied` says of voxel centres, the map
/// around the UAV being perfect. Returns the control points flown.
template <class Occupied>
ControlPoints fly_past(Occupied is_occupied, const std::vector<Mover>& movers, int plans) {
  const Eigen::Vector3d start(-4, 0, 1.5);
  const PlannerParameters parameters;
  Planner planner(parameters, start, {6, 0, 1.5});
  ControlPoints flown(4, start);
  for (int k = 0; k < plans; ++k) {
    Surroundings around;
    const ldm::VoxelIndex centre = ldm::voxel_at(flown.back(), kEdge);
    const ldm::VoxelBox window{centre - ldm::VoxelIndex(32, 32, 12), {64, 64, 24}};
    std::vector<std::uint8_t> occupied(window.count());
    for (std::size_t i = 0; i < window.count(); ++i) {
      const Eigen::Vector3d p = (window.voxel(i).cast<double>().array() + 0.5) * kEdge;
      occupied[i] = is_occupied(p) ? 1 : 0;
    }
    around.still.build(window, kEdge, occupied);
    for (const Mover& mover : movers) {
      // Its first two centres: place at time 0, and velocity.
      Mover predicted{mover.half_size, {}, {}};
      for (std::size_t i = 0; i < planner.sample_count(); ++i) {
        const double t = k * parameters.knot_step + static_cast<double>(i) * planner.sample_step();
        predicted.centre.emplace_back(mover.centre[0] + t * mover.centre[1]);
        predicted.doubt.push_back(0);
      }
      around.movers.push_back(predicted);
    }
    const Plan plan = planner.next({flown.end() - 4, flown.end()}, around);
    flown.push_back(plan.points[4]);
  }
  return flown;
}

TEST(Planner, FliesStraightWhereNothingIsInTheWay) {
  const ControlPoints flown = fly_past([](const Eigen::Vector3d&) { return false; }, {}, 50);
  EXPECT_NEAR((flown.back() - Eigen::Vector3d(6, 0, 1.5)).norm(), 0, 0.05);
  for (const Eigen::Vector3d& p : flown) EXPECT_NEAR(p.y(), 0, 1e-6);
}

/// 0.2 m of radius around (0.1, 0.05); the UAV has 0.3 m.
TEST(Planner, FliesAroundAPillar) {
  const Eigen::Vector2d pillar(0.1, 0.05);
  const ControlPoints flown = fly_past(
      [&](const Eigen::Vector3d& p) { return (p.head<2>() - pillar).norm() < 0.2; }, {}, 60);
  EXPECT_NEAR((flown.back() - Eigen::Vector3d(6, 0, 1.5)).norm(), 0, 0.05);
  const double end = static_cast<double>(flown.size() - 3) * 0.2;
  double least = 9;
  for (double t = 0; t <= end; t += 0.02) {
    least = std::min(least, (datasets::curve_at(flown, 0.2, t).head<2>() - pillar).norm() - 0.2);
  }
  EXPECT_GT(least, 0.3);
  EXPECT_LT(least, 1.2) << "a detour of that width is none around a pillar";
}

/// One that comes along the line, at 1 m/s: the UAV gives way to its prediction.
TEST(Planner, GivesWayToWhatComesTowardsIt) {
  const std::vector<Mover> movers = {{{0.2, 0.2, 1.5}, {{5, 0.1, 1.5}, {-1, 0, 0}}, {}}};
  const ControlPoints flown = fly_past([](const Eigen::Vector3d&) { return false; }, movers, 60);
  EXPECT_NEAR((flown.back() - Eigen::Vector3d(6, 0, 1.5)).norm(), 0, 0.05);
  for (double t = 0; t <= 8; t += 0.02) {
    const Eigen::Vector3d centre(5 - t, 0.1, 1.5);
    const Eigen::Vector3d offset = datasets::curve_at(flown, 0.2, t) - centre;
    EXPECT_GT(box_distance(offset, {0.2, 0.2, 1.5}).value, 0.3) << "at " << t << " s";
  }
}

/// A wall from side to side: it stops before it and stays.
TEST(Planner, StaysBeforeAWall) {
  const ControlPoints flown =
      fly_past([](const Eigen::Vector3d& p) { return p.x() > 1 && p.x() < 1.3; }, {}, 100);
  for (const Eigen::Vector3d& p : flown) EXPECT_LT(p.x(), 1 - 0.3);
  EXPECT_GT(flown.back().x(), -1) << "it comes near";
}

/// A goal that cannot be flown to: it comes near and touches nothing.
TEST(Planner, StaysOffAGoalInsideAnObstacle) {
  const Eigen::Vector3d goal(6, 0, 1.5);
  const ControlPoints flown =
      fly_past([&](const Eigen::Vector3d& p) { return (p - goal).head<2>().norm() < 0.3; }, {}, 80);
  for (const Eigen::Vector3d& p : flown) EXPECT_GT((p - goal).head<2>().norm(), 0.3 + 0.3);
  EXPECT_LT((flown.back() - goal).norm(), 2);
}

/// A wall that appears ahead of the last fixed point at full speed: what is predicted to touch it
/// keeps at least as far off as braking would, and all that is flown within the limits.
TEST(Planner, IsNeverWorseThanBraking) {
  const ControlPoints flown = fly_past([](const Eigen::Vector3d&) { return false; }, {}, 15);
  for (const double ahead : {0.1, 0.3, 0.6, 1.0}) {
    const double wall = flown.back().x() + ahead;
    Surroundings around;
    const ldm::VoxelBox window{ldm::voxel_at(flown.back(), kEdge) - ldm::VoxelIndex(32, 32, 12),
                               {64, 64, 24}};
    std::vector<std::uint8_t> occupied(window.count());
    for (std::size_t i = 0; i < window.count(); ++i) {
      occupied[i] = (window.voxel(i).x() + 0.5) * kEdge > wall ? 1 : 0;
    }
    around.still.build(window, kEdge, occupied);
    Planner planner({}, {-4, 0, 1.5}, {6, 0, 1.5});
    const ControlPoints fixed(flown.end() - 4, flown.end());
    const Plan plan = planner.next(fixed, around);
    ControlPoints stop = braked(fixed, plan.points.size(), 0.2, PlannerParameters().limits);
    EXPECT_GE(plan.clearance, std::min(0.0, planner.clearance(stop, around)));
    EXPECT_EQ(plan.clearance, planner.clearance(plan.points, around));
    ControlPoints cut = plan.points;
    limit(cut, fixed.size(), 0.2, PlannerParameters().limits);
    for (std::size_t i = 0; i < cut.size(); ++i) {
      EXPECT_NEAR((cut[i] - plan.points[i]).norm(), 0, 1e-9) << "a flyable plan is not cut";
    }
  }
}

}  // namespace
}  // namespace experiments
