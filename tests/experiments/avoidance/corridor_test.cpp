#include "experiments/avoidance/corridor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace experiments {
namespace {

datasets::Scenario world(const std::string& name) {
  return datasets::read_scenario(tests::source_folder() / "datasets" / "corridors" /
                                 (name + ".toml"));
}

TEST(Corridor, IsTheSameForTheSameSeedAlone) {
  const datasets::Scenario scenario = world("moving10_10");
  const auto places = [&](std::uint64_t seed) {
    std::vector<Eigen::Vector2d> result;
    for (const auto& obstacle : draw_corridor(scenario, seed).obstacles) {
      result.push_back(obstacle.motion.at(3).position);
    }
    return result;
  };
  EXPECT_EQ(places(5), places(5));
  EXPECT_NE(places(5), places(6));
}

TEST(Corridor, KeepsObstaclesApartAndOffStartAndGoal) {
  for (const char* name : {"still8", "moving10_05", "moving20_15", "reversing_03"}) {
    const datasets::Scenario scenario = world(name);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Corridor corridor = draw_corridor(scenario, seed);
      for (double t = 0; t < scenario.duration(); t += 0.05) {
        for (std::size_t i = 0; i < corridor.obstacles.size(); ++i) {
          const datasets::Obstacle& a = corridor.obstacles[i];
          const Eigen::Vector2d p = a.motion.at(t).position;
          const bool stands = a.motion.is_static();
          if (t < 1.9 || stands) {
            EXPECT_GE((p - corridor.start.head<2>()).norm(), a.body.radius + 1.2);
          }
          if (stands) {
            EXPECT_GE((p - corridor.goal.head<2>()).norm(), a.body.radius + 1.2);
          }
          for (std::size_t j = 0; j < i; ++j) {
            const datasets::Obstacle& b = corridor.obstacles[j];
            EXPECT_GE((p - b.motion.at(t).position).norm(), a.body.radius + b.body.radius + 0.2)
                << name << ", seed " << seed << " at " << t << " s";
          }
        }
      }
    }
  }
}

TEST(Corridor, BringsWhatMovesIntoTheAreaWhileTheUavIsThere) {
  const datasets::Scenario scenario = world("moving10_05");
  for (const auto& obstacle : draw_corridor(scenario, 3).obstacles) {
    bool passes = false;
    for (double t = 0; t <= 12; t += 0.05) {
      const Eigen::Vector2d p = obstacle.motion.at(t).position.cwiseAbs();
      passes = passes || (p.x() <= 8 && p.y() <= 3);
    }
    EXPECT_TRUE(passes) << "obstacle " << obstacle.id;
  }
}

/// With a leg of 10 m at 1 m/s, a tenth of a second more for each turn at 4 m/s^2.
TEST(Corridor, TurnsShuttlesBackAtTheEndOfTheirLeg) {
  const datasets::Scenario scenario = world("reversing_01");
  for (const auto& obstacle : draw_corridor(scenario, 4).obstacles) {
    if (obstacle.motion.is_static()) continue;
    int turns = 0;
    for (double t = 0; t < 40; t += 0.05) {
      const auto before = obstacle.motion.at(t), after = obstacle.motion.at(t + 0.05);
      if (std::abs(after.heading - before.heading) > 1) ++turns;
    }
    EXPECT_GE(turns, 3);
    EXPECT_LE(turns, 4);
  }
}

TEST(Corridor, RefusesOtherScenarios) {
  const auto error = [](const datasets::Scenario& scenario) {
    return tests::message_of<ldm::InvalidInput>([&] { draw_corridor(scenario, 1); });
  };
  datasets::Scenario waypoints =
      datasets::read_scenario(tests::source_folder() / "datasets" / "scenarios" / "scenario1.toml");
  EXPECT_EQ(error(waypoints),
            "world scenario1: uav: allowed: a timetable_s_m whose first and last stop are start "
            "and goal");
  datasets::Scenario people =
      datasets::read_scenario(tests::source_folder() / "datasets" / "scenarios" / "outdoor2.toml");
  EXPECT_NE(error(people).find(".motion = timetable: allowed: static, shuttle"), std::string::npos)
      << error(people);
}

TEST(Corridor, RefusesAGoalAtTheStart) {
  datasets::Scenario scenario = world("still8");
  scenario.uav.timetable.back().place =
      scenario.uav.timetable.front().place + Eigen::Vector3d(0.75, 0, 0);
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { draw_corridor(scenario, 1); }),
            "world still8: uav.timetable_s_m: 0.75 m from start to goal: allowed: at least 1 m");
}

TEST(Corridor, SaysWhereThereIsNoRoom) {
  datasets::Scenario full = world("still8");
  datasets::set_scenario_value(full, "groups.still.count", "300");
  EXPECT_NE(tests::message_of<std::runtime_error>([&] {
              draw_corridor(full, 7);
            }).find("world still8, seed 7: none in 20 attempts; the last: no room for obstacle"),
            std::string::npos);
}

}  // namespace
}  // namespace experiments
