#pragma once
/// Where something is when: scripted motions, as those of the paper's flight outdoors (Sec. 4.2,
/// Fig. 11).
#include <vector>

#include "datasets/random.h"
#include "datasets/scenario/obstacle_motion.h"
#include "datasets/scenario/scenario.h"

namespace datasets {

/// A motion by the group's timetable: from stop to stop with a trapezoidal speed profile, at rest
/// between two stops at the same place and after the last. Each place is moved by up to `spread`
/// along x and y, each time by up to `lateness`, anew for each obstacle.
/// Requires a timetable that can be kept (see `check`).
/// @param speed_scale divides the times
ObstacleMotion draw_timetable_motion(const ObstacleGroup& group, double speed_scale,
                                     Random& random);

/// Acceleration without which a stop could be reached too late, whatever is drawn [m/s^2]; infinity
/// if no acceleration is enough.
double needed_acceleration(const ObstacleGroup& group);

/// Where the UAV's timetable puts it at t [s]: on the straight line between two stops, clamped to
/// the first and the last.
Eigen::Vector3d place_at(const std::vector<Stop<3>>& timetable, double t);

}  // namespace datasets
