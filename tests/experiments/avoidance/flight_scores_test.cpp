#include "experiments/avoidance/flight_scores.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace experiments {
namespace {

/// From the origin 10 m along x, at 2 m/s at most: 5 s are optimal.
FlightTask task() {
  FlightTask result;
  result.corridor.start = {0, 0, 1};
  result.corridor.goal = {10, 0, 1};
  const datasets::ObstacleBody body;
  result.corridor.obstacles.push_back({0, body, 0, datasets::ObstacleMotion({5, 5}, 0)});
  return result;
}

FlightSample sample(double time, const Eigen::Vector3d& position, double speed,
                    const Eigen::Vector3d& acceleration, double clearance) {
  return {time, position, {speed, 0, 0}, acceleration, clearance, false};
}

/// 3, 4 m aside and back to the line: 5 + 7 m of way and 8 m along.
Flight flight(Outcome outcome, double time) {
  Flight result;
  result.outcome = outcome;
  result.samples = {sample(0, {0, 0, 1}, 0, {0, 0, 0}, 2),
                    sample(time / 2, {3, 4, 1}, 2.5, {0, 3, 0}, 0.25),
                    sample(time, {10, 4, 1}, 2, {4, 3, 0}, 0.5)};
  result.brakings = 2;
  return result;
}

std::map<std::string, std::optional<double>> scores_of(const Flight& flown) {
  std::map<std::string, std::optional<double>> result;
  for (const auto& [name, value] : flight_scores(task(), flown)) result[std::string(name)] = value;
  return result;
}

TEST(FlightScores, OfAFlightWorkedByHand) {
  auto scores = scores_of(flight(Outcome::kReached, 20));
  EXPECT_EQ(scores["success"], 1);
  EXPECT_EQ(scores["time_s"], 20);
  EXPECT_DOUBLE_EQ(*scores["length_ratio"], (5 + 7) / 10.0);
  EXPECT_DOUBLE_EQ(*scores["jerk_integral_mps2"], 3 + 4);
  EXPECT_EQ(scores["least_clearance_m"], 0.25);
  EXPECT_EQ(scores["brakings"], 2);
  EXPECT_EQ(scores["speed_violations"], 1);         // 2.5 m/s
  EXPECT_EQ(scores["acceleration_violations"], 1);  // 5 m/s^2
  EXPECT_EQ(scores["barn"], 5.0 / 20);
}

TEST(FlightScores, ClipTheTimeOfBarn) {
  EXPECT_EQ(scores_of(flight(Outcome::kReached, 6))["barn"], 0.5);  // at least twice optimal
  EXPECT_EQ(scores_of(flight(Outcome::kReached, 100))["barn"], 1 / 8.0);
  EXPECT_EQ(scores_of(flight(Outcome::kHitMoving, 6))["barn"], 0);
}

TEST(FlightScores, SayHowAFlightEnded) {
  Flight hit = flight(Outcome::kHitBraking, 6);
  hit.hit = 0;
  hit.hit_known_from = 3.5;
  auto scores = scores_of(hit);
  EXPECT_EQ(scores["success"], 0);
  EXPECT_EQ(scores["hit_braking"], 1);
  EXPECT_EQ(scores["hit_moving"], 0);
  EXPECT_EQ(scores["hit_known_from_m"], 3.5);
  for (const char* name : {"time_s", "length_ratio", "jerk_integral_mps2"}) {
    EXPECT_EQ(scores[name], std::nullopt) << name << " of a flight that ended early means nothing";
  }
  EXPECT_EQ(scores_of(flight(Outcome::kTimeOut, 6))["timed_out"], 1);
}

}  // namespace
}  // namespace experiments
