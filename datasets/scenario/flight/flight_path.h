#pragma once
/// The UAV's flight path: a uniform cubic B-spline through waypoints, fitted with Ceres.
#include <vector>

#include "ldm/types.h"

namespace datasets {

/// Space the path stays out of: an upright cylinder that moves.
struct KeepOut {
  double radius = 0;                    ///< [m]
  double z_min = 0, z_max = 0;          ///< world [m]
  std::vector<Eigen::Vector2d> centre;  ///< world [m], one per `FlightTask::sample_step`
};

struct FlightTask {
  std::vector<Eigen::Vector3d> waypoints;  ///< world [m], passed near in this order, at least 2
  double duration = 120;                   ///< [s]
  double sample_step = 0.1;     ///< spacing of the clearance checks and of KeepOut::centre [s]
  double max_speed = 2;         ///< [m/s]
  double max_acceleration = 2;  ///< [m/s^2]
  double waypoint_radius = 4;   ///< greatest distance at which a waypoint counts as passed [m]
  double clearance = 0.6;       ///< least distance of the UAV's centre from any keep-out [m]
  std::vector<KeepOut> keep_outs;
};

class FlightPath {
 public:
  /// The path lasts (control_points.size() - 3) * knot_step.
  /// @param knot_step spacing of the control points in time [s]
  /// @throws ldm::InvalidInput unless there are 4 control points and knot_step > 0.
  FlightPath(std::vector<Eigen::Vector3d> control_points, double knot_step);
  /// t in [0, duration], clamped. World frame.
  Eigen::Vector3d position(double t) const;
  Eigen::Vector3d velocity(double t) const;
  Eigen::Vector3d acceleration(double t) const;
  /// Pose of a multirotor that flies the path: heading along the horizontal velocity (smoothed),
  /// thrust axis along acceleration minus gravity.
  ldm::Pose T_world_uav(double t) const;

 private:
  void tow_headings();
  double first_heading() const;
  double heading(double t) const;

  std::vector<Eigen::Vector3d> control_points_;
  double knot_step_;
  std::vector<double> headings_;  // [rad], not wrapped; evenly spaced in time
};

/// Pose (T_world_uav) of a multirotor with that acceleration [m/s^2] and heading [rad].
ldm::Pose multirotor_pose(const Eigen::Vector3d& position, const Eigen::Vector3d& acceleration,
                          double heading);

/// Fit smoothness, waypoints, limits and clearance. Same task, same bits. The path passes
/// beside a waypoint where a limit or a keep-out keeps it off. Cost: about 0.1 s for 120 s and 20
/// keep-outs.
/// @throws std::runtime_error naming the broken limit, its value and the time, if the fitted path
/// breaks one at any sample: the caller draws another world.
/// @throws ldm::InvalidInput naming the field of a task that makes no sense.
FlightPath fit_flight_path(const FlightTask& task);

}  // namespace datasets
