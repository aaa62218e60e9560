#pragma once
/// What a seed makes of a scenario: obstacles that never meet, and a flight among them (paper Sec.
/// 4.1.1, Fig. 5).
#include <cstdint>
#include <vector>

#include "datasets/scenario/flight/flight_path.h"
#include "datasets/scenario/obstacle.h"
#include "datasets/scenario/scenario.h"

namespace datasets {

struct World {
  std::vector<Obstacle> obstacles;  ///< sorted by id
  FlightPath path;                  ///< of the UAV, over the scenario's duration
};

/// Obstacles keep the scenario's gap from one another and its clearance from the UAV at all times
/// of the log, and stay in its area. The same scenario and seed give the same bits. Cost: up
/// to 1 s, most of it for the flight path.
/// @throws std::runtime_error naming scenario, seed and reason if there is no room for such a world
/// after a bounded number of attempts.
World draw_world(const Scenario& scenario, std::uint64_t seed);

}  // namespace datasets
