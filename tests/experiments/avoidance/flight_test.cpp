#include "experiments/avoidance/flight.h"

#include <gtest/gtest.h>

#include "experiments/avoidance/arms.h"
#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace experiments {
namespace {

datasets::Scenario world(const std::string& name) {
  return datasets::read_scenario(tests::source_folder() / "datasets" / "corridors" /
                                 (name + ".toml"));
}

FlightTask task_in(const datasets::Scenario& scenario, std::uint64_t seed) {
  return {.corridor = draw_corridor(scenario, seed),
          .sensor = scenario.sensor,
          .noise_seed = seed,
          .planner = {}};
}

Flight fly_as(std::string_view name, const FlightTask& task) {
  const Arm arm = find_arm(name);
  return fly(task, *arm.sight(arm_parameters(arm), task.corridor));
}

/// From (0, 0, 1.5) to (8, 0, 1.5), with boxes 3 m high of that size and place.
FlightTask among_boxes(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& boxes) {
  FlightTask task = task_in(world("still8"), 1);
  task.corridor = {{}, {0, 0, 1.5}, {8, 0, 1.5}, 15};
  for (const auto& [place, size] : boxes) {
    datasets::ObstacleBody body;
    body.solids.push_back({datasets::Solid::Shape::kBox, {}, {size.x(), size.y(), 3}});
    body.radius = size.norm() / 2;
    body.height = 3;
    const auto id = static_cast<std::int32_t>(task.corridor.obstacles.size());
    task.corridor.obstacles.push_back({id, body, 0, datasets::ObstacleMotion(place, 0)});
  }
  return task;
}

TEST(Flight, IsTheSameBitForBit) {
  const FlightTask task = task_in(world("moving10_10"), 2);
  const Flight a = fly_as("ldm", task), b = fly_as("ldm", task);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.samples.back().clearance, b.samples.back().clearance);
}

TEST(Flight, IsJudgedByTheShapesAtEveryTwentiethOfASecond) {
  // Blind, at full cruise into a wall whose face is at x = 4.
  const Flight flight = fly_as("blind", among_boxes({{{4.5, 0}, {1, 4}}}));
  EXPECT_EQ(flight.outcome, Outcome::kHitStatic);
  EXPECT_EQ(flight.hit, 0);
  EXPECT_EQ(flight.hit_known_from, 0) << "it was never known";
  EXPECT_LE(flight.samples.back().clearance, 0);
  EXPECT_GT(flight.samples.back().clearance, -0.02 * 2) << "found within a step";
  for (std::size_t i = 0; i < flight.samples.size(); ++i) {
    EXPECT_NEAR(flight.samples[i].time, 0.02 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(flight.samples[i].clearance, 4 - 0.3 - flight.samples[i].position.x(), 1e-9);
  }
}

TEST(Flight, ReachesTheGoalRoundAPillarThatTheMapShows) {
  const FlightTask task = among_boxes({{{4, 0.05}, {0.4, 0.4}}});
  EXPECT_EQ(fly_as("blind", task).outcome, Outcome::kHitStatic);
  for (const char* arm : {"current_scan", "circular_buffer", "octomap", "ldm", "oracle"}) {
    const Flight flight = fly_as(arm, task);
    EXPECT_EQ(flight.outcome, Outcome::kReached) << arm;
    EXPECT_LT((flight.samples.back().position - task.corridor.goal).norm(), 0.5);
    EXPECT_FALSE(flight.hit);
  }
}

TEST(Flight, EndsAtOnceWhereTheStartIsInsideAnObstacle) {
  const Flight flight = fly_as("circular_buffer", among_boxes({{{0.3, 0}, {1, 1}}}));
  EXPECT_EQ(flight.outcome, Outcome::kHitStatic);
  EXPECT_EQ(flight.samples.size(), 1U);
  EXPECT_EQ(flight.samples.back().time, 0);
  EXPECT_EQ(flight.map_ms.size(), 1U) << "its record has times, too";
}

TEST(Flight, TimesOutBeforeAGoalInsideAnObstacle) {
  const Flight flight = fly_as("circular_buffer", among_boxes({{{8, 0}, {1.6, 1.6}}}));
  EXPECT_EQ(flight.outcome, Outcome::kTimeOut);
  EXPECT_NEAR(flight.samples.back().time, 15, 1e-9);
  EXPECT_LT((flight.samples.back().position - Eigen::Vector3d(8, 0, 1.5)).norm(), 2.5);
}

TEST(Flight, TimesOutWhereThereIsNoWayThrough) {
  const Flight flight = fly_as("circular_buffer", among_boxes({{{4, 0}, {0.3, 40}}}));
  EXPECT_EQ(flight.outcome, Outcome::kTimeOut);
}

/// At every instant: first and second differences of its control points bound velocity and
/// acceleration of a cubic B-spline.
TEST(Flight, NeverBreaksItsLimits) {
  constexpr double kKnot = 0.2;
  for (const char* arm : {"circular_buffer", "object_ldm", "oracle"}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Flight flight = fly_as(arm, task_in(world("moving20_15"), seed));
      const ControlPoints& p = flight.points;
      for (std::size_t i = 1; i < p.size(); ++i) {
        EXPECT_LE((p[i] - p[i - 1]).norm(), 2 * kKnot + 1e-9);
      }
      for (std::size_t i = 2; i < p.size(); ++i) {
        EXPECT_LE((p[i] - 2 * p[i - 1] + p[i - 2]).norm(), 4 * kKnot * kKnot + 1e-9);
      }
      for (const FlightSample& sample : flight.samples) {
        EXPECT_LE(sample.velocity.norm(), 2 + 1e-9);
        EXPECT_LE(sample.acceleration.norm(), 4 + 1e-9);
      }
    }
  }
}

/// Without delay the first plan moves the UAV at once.
TEST(Flight, ActsAfterItsDelay) {
  const auto first_moving = [](double delay) {
    FlightTask task = among_boxes({});
    task.delay = delay;
    const Flight flight = fly_as("blind", task);
    for (const FlightSample& sample : flight.samples) {
      if (sample.velocity.norm() > 1e-9) return sample.time;
    }
    return -1.0;
  };
  EXPECT_NEAR(first_moving(0), 0.02, 1e-9);
  EXPECT_NEAR(first_moving(0.2), 0.22, 1e-9);
  EXPECT_NEAR(first_moving(0.3), 0.42, 1e-9) << "at the first knot after the delay";
}

TEST(Flight, RefusesADelayAndASensorThatDoNotFit) {
  FlightTask task = among_boxes({});
  task.delay = 1.5;
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { fly_as("blind", task); }),
            "delay = 1.500000: allowed: 0 to 1 s");
  task.delay = 0.2;
  task.sensor.rate = 8;
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { fly_as("blind", task); }),
            "sensor.rate_hz = 8.000000: allowed: a whole number of scans in a knot step of "
            "0.200000 s");
}

/// The table of docs/avoidance.md.
TEST(Arms, HaveTheTrustThatTheStudyOfMarginsChose) {
  const auto trust = [](std::string_view arm) {
    return std::pair(find_arm(arm).trust.margin, find_arm(arm).trust.doubt);
  };
  EXPECT_EQ(trust("ldm"), std::pair(0.2, 2.0));
  EXPECT_EQ(trust("object_ldm"), std::pair(0.2, 2.0));
  EXPECT_EQ(trust("circular_buffer_pf"), std::pair(0.3, 1.0));
  EXPECT_EQ(trust("circular_buffer"), std::pair(0.3, 1.0));
  EXPECT_EQ(trust("octomap"), std::pair(0.2, 1.0));
  EXPECT_EQ(trust("current_scan"), std::pair(0.2, 1.0));
  EXPECT_EQ(trust("oracle"), std::pair(0.1, 1.0));
}

TEST(Arms, AreControlsAndMethods) {
  EXPECT_EQ(find_arm("ldm").method, &find_method("ldm"));
  EXPECT_EQ(find_arm("oracle").method, nullptr);
  EXPECT_EQ(find_arm("oracle_future").trust.margin, find_arm("oracle").trust.margin);
  EXPECT_EQ(find_arm("empty_map").trust.margin, Trust().margin) << "of those not tuned the default";
  EXPECT_NE(tests::message_of<ldm::InvalidInput>([] {
              find_arm("orcale");
            }).find("unknown arm orcale: allowed: blind, oracle, oracle_future, ldm, "),
            std::string::npos);
}

}  // namespace
}  // namespace experiments
