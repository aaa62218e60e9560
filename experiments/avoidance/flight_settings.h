#pragma once
/// What decides a flight beside its world, and its values by name (docs/avoidance.md).
#include <string_view>

#include "experiments/avoidance/arms.h"
#include "experiments/avoidance/planner/planner.h"
#include "experiments/method/settings.h"

namespace experiments {

struct FlightSettings {
  Arm arm;
  ldm::Parameters map;
  PlannerParameters planner;
  double delay = 0.2;  ///< from a scan until what was planned upon it is flown [s]
};

/// Calls `visit(name, double& value, min, max)` for each value that is not the map's.
template <class S, class Visitor>
void visit_flight_settings(S& s, Visitor&& visit) {
  visit("trust.margin_m", s.arm.trust.margin, 0, 1);
  visit("trust.doubt", s.arm.trust.doubt, 0, 10);
  visit("trust.moving_from_mps", s.arm.trust.moving_from, 0, 100);
  visit("flight.delay_s", s.delay, 0, 1);
  visit("flight.radius_m", s.planner.radius, 0.05, 1);
  visit("flight.cruise_mps", s.planner.cruise, 0.1, 20);
  visit("flight.speed_mps", s.planner.limits.speed, 0.1, 20);
  visit("flight.acceleration_mps2", s.planner.limits.acceleration, 0.1, 50);
}

/// Those of an arm: the defaults, its map's over the window that every arm has.
FlightSettings flight_settings(std::string_view arm);

/// True if the arm has a use for the value: trust, flight, and what its map reads.
bool uses(const FlightSettings& settings, std::string_view name);

/// @throws ldm::InvalidInput naming place, value and what is allowed
void apply(const Setting& setting, FlightSettings& settings);

}  // namespace experiments
