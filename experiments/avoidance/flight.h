#pragma once
/// The closed loop: scan, map, plan, fly, and who is hit (docs/avoidance.md).
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "datasets/scenario/simulation.h"
#include "experiments/avoidance/corridor.h"
#include "experiments/avoidance/planner/planner.h"
#include "experiments/avoidance/sight.h"

namespace experiments {

/// How a flight ends.
enum class Outcome { kReached, kHitStatic, kHitMoving, kHitBraking, kTimeOut };
inline constexpr std::string_view kOutcomeNames[] = {"reached", "hit_static", "hit_moving",
                                                     "hit_braking", "time_out"};

/// Every 20 ms; world frame.
struct FlightSample {
  double time = 0;  ///< [s]
  Eigen::Vector3d position, velocity, acceleration;
  double clearance = 0;  ///< of the UAV's surface from the nearest obstacle [m]
  bool braking = false;  ///< what is flown here is a braking plan
};

struct Flight {
  Outcome outcome = Outcome::kTimeOut;
  std::vector<FlightSample> samples;     ///< the last is where it ended
  ControlPoints points;                  ///< of the path flown
  std::optional<std::int32_t> hit;       ///< id of the obstacle that was hit
  std::optional<double> hit_known_from;  ///< distance at which it was first known; 0: never [m]
  std::int64_t brakings = 0;             ///< times that a braking plan followed another one
  /// Processor time of each scan's way into the map, of each plan's distance field, and of its
  /// optimisation.
  std::vector<double> map_ms, field_ms, solve_ms;
};

struct FlightTask {
  Corridor corridor;
  datasets::SensorDescription sensor;
  std::uint64_t noise_seed = 0;  ///< of the ranges
  PlannerParameters planner;
  double delay = 0.2;  ///< from a scan until what was planned upon it is flown [s]
};

/// What is told after every scan, for logs and films.
struct FlightMoment {
  const datasets::Frame& frame;
  const Plan& plan;       ///< the latest; its spline begins at the scan it was made from,
  double planned_at = 0;  ///< at this time [s]
};
using FlightObserver = std::function<void(const FlightMoment&)>;

/// Fly from start to goal: a scan at every revolution of the LiDAR, a plan at every knot step from
/// the scans until then, which takes effect at the first knot after the delay. The UAV is a ball
/// that flies its spline exactly; the exact shapes judge it every 20 ms. A start inside an obstacle
/// is a hit at time 0. The same task and sight give the same bits, but for times.
/// @throws ldm::InvalidInput unless the delay is in 0..1 s and the knot step holds a whole number
/// of scans
Flight fly(const FlightTask& task, Sight& sight, const FlightObserver& observer = {});

}  // namespace experiments
