#pragma once
/// An obstacle: its shape, its motion, and its true state at a time (paper Sec. 4.1.1).
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/frame.h"
#include "datasets/scenario/obstacle_motion.h"
#include "datasets/scenario/scenario.h"

namespace datasets {

/// How the legs of a walker swing: about the hip, forward and back once in a stride, one against
/// the other; wider the faster it goes, and not at all at rest.
struct Gait {
  double stride = 0;                        ///< way between two steps of the same foot [m]
  double phase = 0;                         ///< of the swing where a leg of the way begins [rad]
  double widest = 0;                        ///< angle from upright at full speed [rad]
  std::size_t left_leg = 0, right_leg = 0;  ///< their places in `solids`
};

/// Solids posed in the obstacle's frame: x the way it faces, z up, origin the centre of its box.
struct ObstacleBody {
  std::vector<Solid> solids;  ///< `T_world_solid` holds the pose in the obstacle's frame
  double radius = 0;          ///< of the smallest upright cylinder around the origin [m]
  double height = 0;          ///< [m]
  std::optional<Gait> gait = {};
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
