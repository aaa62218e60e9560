/// Scripted motions: people and the UAV are where their timetable says, in every drawn world.
#include "datasets/scenario/timetable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "datasets/scenario/simulation.h"
#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

Scenario outdoor(const std::string& name) {
  return read_scenario(tests::source_folder() / "datasets" / "scenarios" / (name + ".toml"));
}

/// 2 m along x in 4 s with 1 m/s^2, a second's rest, and back.
ObstacleGroup there_and_back() {
  ObstacleGroup group;
  group.motion = ObstacleMotionKind::kTimetable;
  group.acceleration = {1, 1};
  group.timetable = {{1, {0, 3}}, {5, {2, 3}}, {6, {2, 3}}, {10, {0, 3}}};
  return group;
}

TEST(TimetableTest, KeepsItsTimes) {
  Random random(1);
  const ObstacleMotion motion = draw_timetable_motion(there_and_back(), 1, random);
  const double speed = 2 - std::sqrt(2.0);  // v (T - v / a) = 2 m
  EXPECT_NEAR(motion.top_speed(), speed, 1e-12);
  EXPECT_EQ(motion.at(0).position, Eigen::Vector2d(0, 3));
  EXPECT_EQ(motion.at(0).acceleration, Eigen::Vector2d(0, 0));
  EXPECT_NEAR(motion.at(3).position.x(), 1, 1e-12);
  EXPECT_NEAR(motion.at(3).velocity.x(), speed, 1e-12);
  EXPECT_NEAR(motion.at(3).walked, 1, 1e-12);
  EXPECT_NEAR(motion.at(3).pace, 1, 1e-12);
  EXPECT_EQ(motion.at(5.5).velocity, Eigen::Vector2d(0, 0));
  EXPECT_EQ(motion.at(5.5).pace, 0);
  EXPECT_NEAR(motion.at(5.5).position.x(), 2, 1e-12);
  EXPECT_NEAR(motion.at(8).velocity.x(), -speed, 1e-12);
  EXPECT_NEAR(motion.at(99).position.x(), 0, 1e-12);
}

TEST(TimetableTest, SpeedScaleShortensTheTimes) {
  Random random(1);
  const ObstacleMotion motion = draw_timetable_motion(there_and_back(), 2, random);
  EXPECT_NEAR(motion.top_speed(), 2 * (2 - std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(motion.at(1.5).position.x(), 1, 1e-12);
}

TEST(TimetableTest, ASingleStopIsAPlaceToStand) {
  ObstacleGroup group = there_and_back();
  group.timetable = {{0, {1, 2}}};
  Random random(1);
  const ObstacleMotion motion = draw_timetable_motion(group, 1, random);
  EXPECT_TRUE(motion.is_static());
  EXPECT_EQ(motion.at(7).position, Eigen::Vector2d(1, 2));
}

TEST(TimetableTest, SpreadMovesPlacesAndLatenessTimes) {
  ObstacleGroup group = there_and_back();
  group.spread = 0.1;
  group.lateness = 0.2;
  group.acceleration = {1, 2};
  ASSERT_LE(needed_acceleration(group), 1);
  Random random(5);
  double farthest = 0;
  for (int i = 0; i < 200; ++i) {
    const ObstacleMotion motion = draw_timetable_motion(group, 1, random);
    for (const Stop<2>& stop : group.timetable) {
      // Late by 0.2 s at most, at full speed, and off by a tenth of a metre along each axis.
      const Eigen::Vector2d off = motion.at(stop.time).position - stop.place;
      EXPECT_LE(off.cwiseAbs().maxCoeff(), 0.1 + 0.2 * motion.top_speed());
      farthest = std::max(farthest, off.cwiseAbs().maxCoeff());
    }
    EXPECT_EQ(motion.at(5.3).position, motion.at(5.7).position) << "a rest is a rest";
    EXPECT_LE((motion.at(99).position - group.timetable.back().place).cwiseAbs().maxCoeff(), 0.1);
  }
  EXPECT_GT(farthest, 0.09);
}

TEST(TimetableTest, NeededAccelerationIsThatOfTheHardestLeg) {
  ObstacleGroup group = there_and_back();
  EXPECT_DOUBLE_EQ(needed_acceleration(group), 4 * 2 / 16.0);
  group.lateness = 0.6;  // the second's rest may come to nothing
  EXPECT_EQ(needed_acceleration(group), std::numeric_limits<double>::infinity());
}

TEST(TimetableTest, PlacesOfTheUavLieOnLines) {
  const std::vector<Stop<3>> stops = {{1, {0, 0, 1}}, {3, {0, 4, 2}}, {4, {0, 4, 2}}};
  EXPECT_EQ(place_at(stops, 0), Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(place_at(stops, 2), Eigen::Vector3d(0, 2, 1.5));
  EXPECT_EQ(place_at(stops, 3.5), Eigen::Vector3d(0, 4, 2));
  EXPECT_EQ(place_at(stops, 9), Eigen::Vector3d(0, 4, 2));
}

TEST(OutdoorTest, TheUavHoversAndTheNearerHidesTheFarther) {
  const Scenario scenario = outdoor("outdoor1");
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Simulation simulation(scenario, seed);
    Frame frame;
    std::vector<std::int64_t> hits_of_person3;
    while (simulation.next(frame)) {
      const Eigen::Vector3d& uav = frame.scan.T_world_uav.translation;
      EXPECT_LT((uav - Eigen::Vector3d(0, 0, 1.1)).norm(), 0.3);
      ASSERT_EQ(frame.truth->objects.size(), 3u);
      EXPECT_FALSE(frame.truth->objects[0].dynamic);
      for (const ObjectState& person : frame.truth->objects) {
        // The whole body is in the map of 4.8 m but for a voxel or two.
        EXPECT_LT((person.position - uav).head<2>().cwiseAbs().maxCoeff(), 2.4 - 0.15);
      }
      const auto& solids = frame.truth->objects[2].solids;
      hits_of_person3.push_back(std::count_if(
          frame.truth->noise_free_hits.begin(), frame.truth->noise_free_hits.end(),
          [&](const ldm::Point& hit) {
            const Eigen::Vector3d offset = hit.cast<double>() - frame.truth->objects[2].position;
            return offset.head<2>().norm() < 0.5 && !solids.empty();
          }));
    }
    const auto hidden = std::count(hits_of_person3.begin(), hits_of_person3.end(), 0);
    EXPECT_GE(hidden, 2) << seed;
    EXPECT_LE(hidden, 20) << seed;
    EXPECT_GT(hits_of_person3.front(), 50);
  }
}

TEST(OutdoorTest, TheUavAndThePersonMoveTheSameWay) {
  Simulation simulation(outdoor("outdoor2"), 3);
  const FlightPath& path = simulation.world().path;
  const Obstacle& person = simulation.world().obstacles.at(0);
  for (const double t : {6.0, 8.0, 11.0, 18.0, 23.0}) {
    const Eigen::Vector2d walk = person.motion.at(t).velocity;
    const double way = t < 14 ? 1 : -1;
    EXPECT_GT(way * walk.y(), 0.6) << t;
    EXPECT_GT(path.velocity(t).head<2>().normalized().dot(walk.normalized()), 0.95) << t;
    EXPECT_LT((path.position(t).head<2>() - person.motion.at(t).position).norm(), 2.0) << t;
  }
}

TEST(OutdoorTest, SeedsDrawOtherWorlds) {
  const Scenario scenario = outdoor("outdoor1");
  const World one = draw_world(scenario, 1), again = draw_world(scenario, 1);
  const World other = draw_world(scenario, 2);
  EXPECT_EQ(one.path.position(7), again.path.position(7));
  EXPECT_NE(one.path.position(7), other.path.position(7));
  EXPECT_NE(one.obstacles[1].motion.at(12).position, other.obstacles[1].motion.at(12).position);
  EXPECT_NE(one.obstacles[1].body.gait->phase, other.obstacles[1].body.gait->phase);
}

TEST(OutdoorTest, AFlightThroughAPersonIsRefused) {
  Scenario scenario = outdoor("outdoor1");
  scenario.uav.timetable = {{0, {0.3, -1.5, 1.1}}};
  const std::string message =
      tests::message_of<std::runtime_error>([&] { draw_world(scenario, 1); });
  EXPECT_NE(message.find("flight breaks clearance: "), std::string::npos) << message;
}

}  // namespace
}  // namespace datasets
