#pragma once
/// First guess of the flight path: the waypoints' polyline, led around the keep-outs (paper
/// Sec. 4.1.1).
#include <vector>

#include "datasets/scenario/flight/flight_path.h"

namespace datasets {

/// A waypoint and when the path is to pass it.
struct TimedWaypoint {
  double time = 0;                                     ///< [s]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< world [m]
};

/// The waypoints of `task` at the times when a UAV of constant speed meets them on the polyline;
/// at equal intervals if they are all the same point.
std::vector<TimedWaypoint> time_waypoints(const FlightTask& task);

/// Where the polyline is at t [s], clamped to its first and last time.
Eigen::Vector3d on_polyline(const std::vector<TimedWaypoint>& waypoints, double t);

/// Positions at the times 0, step, ..., `steps` * step [s]: the cheapest walk over a horizontal
/// grid that keeps beside the polyline, off the keep-outs and under the speed limit. The cheapest
/// of all, found by dynamic programming: where a local fit would be caught between two keep-outs,
/// the walk has already waited or gone round. A walk that cannot keep off a keep-out crosses it.
/// Requires a polyline that is flown at no more than task.max_speed. Cost: about 10 ms for 200
/// steps and 20 keep-outs.
std::vector<Eigen::Vector3d> route(const FlightTask& task,
                                   const std::vector<TimedWaypoint>& waypoints, double step,
                                   std::size_t steps);

}  // namespace datasets
