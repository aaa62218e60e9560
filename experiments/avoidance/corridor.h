#pragma once
/// Worlds to fly through: obstacles that do not see the UAV, between its start and its goal (closed
/// loop; docs/avoidance.md).
#include <cstdint>
#include <vector>

#include "datasets/scenario/obstacle.h"
#include "datasets/scenario/scenario.h"

namespace experiments {

struct Corridor {
  std::vector<datasets::Obstacle> obstacles;        ///< sorted by id
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< of the UAV, at rest, world [m]
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();   ///< world [m]
  double duration = 0;                              ///< after which a flight is given up [s]
};

/// Draw a world from a scenario with a flight by timetable: from its first stop to its last, at the
/// times that the UAV finds. Obstacles keep the scenario's gap from one another. Static ones stand
/// in its area, off start and goal by `uav.clearance`; a shuttle passes a place in the area at a
/// time between the first stop and the last, on a line of the group's `leg`, and keeps off the
/// start for the first two seconds. The same scenario and seed give the same bits.
/// @throws ldm::InvalidInput if the scenario has another flight, a goal less than 1 m from the
/// start, or another motion of obstacles
/// @throws std::runtime_error naming scenario, seed and reason if there is no room for such a world
/// after a bounded number of attempts.
Corridor draw_corridor(const datasets::Scenario& scenario, std::uint64_t seed);

}  // namespace experiments
