#pragma once
/// What a planner is told of the space around the UAV: the distance field of what stands, and boxes
/// of what moves, with where they will be (closed loop after [11] of the paper).
#include <vector>

#include "experiments/avoidance/planner/distance_field.h"

namespace experiments {

/// A box that moves, along the world's axes.
struct Mover {
  Eigen::Vector3d half_size = Eigen::Vector3d::Zero();  ///< [m]
  std::vector<Eigen::Vector3d> centre;                  ///< at each sample of a plan, world [m]
  std::vector<double> doubt;  ///< by which it is wider for not knowing better, each sample [m]
};

struct Surroundings {
  /// Beyond this distance nothing is seen by the costs [m].
  static constexpr double kReach = 1.5;

  DistanceField still{kReach};
  std::vector<Mover> movers;
  double margin = 0;  ///< taken off all distances, for what the map gets wrong [m]

  /// From what stands; world point p [m].
  Distance from_still(const Eigen::Vector3d& p) const;
  /// From the nearest of what moves, at that sample; at most kReach.
  Distance from_moving(std::size_t sample, const Eigen::Vector3d& p) const;
};

/// Signed distance of `offset` from the surface of a box around the origin, negative inside [m].
/// The gradient is a unit vector; at the centre it is +x.
Distance box_distance(const Eigen::Vector3d& offset, const Eigen::Vector3d& half_size);

}  // namespace experiments
