#pragma once
/// An obstacle: its shape, its motion, and its true state at a time (paper Sec. 4.1.1).
#include <cstdint>
#include <vector>

#include "datasets/frame.h"
#include "datasets/obstacle_motion.h"
#include "datasets/scenario.h"

namespace datasets {

/// Solids posed in the obstacle's frame: x the way it faces, z up, origin the centre of its box.
struct ObstacleBody {
  std::vector<Solid> solids;  ///< `T_world_solid` holds the pose in the obstacle's frame
  double radius = 0;          ///< of the smallest upright cylinder around the origin [m]
  double height = 0;          ///< [m]
};

/// Draw the sizes and build the solids of one of the group.
ObstacleBody draw_body(const ObstacleGroup& group, Random& random);

struct Obstacle {
  std::int32_t id = 0;
  ObstacleBody body;
  double bottom = 0;  ///< its lowest point above z = 0 [m]
  ObstacleMotion motion;

  /// Fill `state` with the truth at t [s]; reuses its memory.
  void state_at(double t, ObjectState& state) const;
};

}  // namespace datasets
