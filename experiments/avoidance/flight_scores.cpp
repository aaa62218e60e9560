#include "experiments/avoidance/flight_scores.h"

#include <algorithm>

namespace experiments {
namespace {

/// Rounding of the spline's evaluation is no violation of a limit.
constexpr double kRounding = 1e-9;

double path_length(const Flight& flight) {
  double length = 0;
  for (std::size_t i = 1; i < flight.samples.size(); ++i) {
    length += (flight.samples[i].position - flight.samples[i - 1].position).norm();
  }
  return length;
}

/// Jerk is constant between knots, so that between two samples it is their difference over time.
double jerk_integral(const Flight& flight) {
  double sum = 0;
  for (std::size_t i = 1; i < flight.samples.size(); ++i) {
    sum += (flight.samples[i].acceleration - flight.samples[i - 1].acceleration).norm();
  }
  return sum;
}

double least_clearance(const Flight& flight) {
  return std::min_element(flight.samples.begin(), flight.samples.end(),
                          [](const auto& a, const auto& b) { return a.clearance < b.clearance; })
      ->clearance;
}

/// Samples above a limit.
template <class Value>
double violations(const Flight& flight, double limit, Value value) {
  return static_cast<double>(
      std::count_if(flight.samples.begin(), flight.samples.end(),
                    [&](const FlightSample& s) { return value(s) > limit + kRounding; }));
}

}  // namespace

FlightScores flight_scores(const FlightTask& task, const Flight& flight) {
  const bool reached = flight.outcome == Outcome::kReached;
  const auto if_reached = [&](double value) {
    return reached ? std::optional(value) : std::nullopt;
  };
  const double straight = (task.corridor.goal - task.corridor.start).norm();
  const double time = flight.samples.back().time;
  const double optimal = straight / task.planner.limits.speed;
  const auto ended_by = [&](Outcome outcome) { return flight.outcome == outcome ? 1.0 : 0.0; };
  const double clearance = least_clearance(flight);
  return {
      {"success", ended_by(Outcome::kReached)},
      {"hit_static", ended_by(Outcome::kHitStatic)},
      {"hit_moving", ended_by(Outcome::kHitMoving)},
      {"hit_braking", ended_by(Outcome::kHitBraking)},
      {"timed_out", ended_by(Outcome::kTimeOut)},
      {"time_s", if_reached(time)},
      {"length_ratio", if_reached(path_length(flight) / straight)},
      {"jerk_integral_mps2", if_reached(jerk_integral(flight))},
      {"least_clearance_m",
       task.corridor.obstacles.empty() ? std::nullopt : std::optional(clearance)},
      {"brakings", static_cast<double>(flight.brakings)},
      {"speed_violations", violations(flight, task.planner.limits.speed,
                                      [](const auto& s) { return s.velocity.norm(); })},
      {"acceleration_violations", violations(flight, task.planner.limits.acceleration,
                                             [](const auto& s) { return s.acceleration.norm(); })},
      {"hit_known_from_m", flight.hit_known_from},
      {"barn", reached ? optimal / std::clamp(time, 2 * optimal, 8 * optimal) : 0},
  };
}

}  // namespace experiments
