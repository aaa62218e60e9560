#pragma once
/// Motion of an obstacle: legs in the xy plane, from rest to rest (paper Sec. 4.1.1, Fig. 5).
#include <vector>

#include "datasets/random.h"
#include "datasets/scenario/scenario.h"

namespace datasets {

/// At one time; world frame.
struct MotionState {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();      ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();      ///< [m/s]
  Eigen::Vector2d acceleration = Eigen::Vector2d::Zero();  ///< [m/s^2]
  double heading = 0;                                      ///< [rad]
  double walked = 0;                                       ///< since the leg began [m]
  double pace = 0;  ///< share of the speed reached on this leg, 0 to 1
};

/// From rest to rest along a straight line, with a trapezoidal speed profile; then a rest.
struct Leg {
  double start = 0;                                      ///< time at which it sets out [s]
  Eigen::Vector2d from = Eigen::Vector2d::Zero();        ///< [m]
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit vector
  double length = 0;                                     ///< [m]
  double top_speed = 0;     ///< reached only if the leg is long enough [m/s]
  double acceleration = 0;  ///< also of the braking [m/s^2]
  double pause = 0;         ///< rest at its end [s]

  double ramp_time() const;    ///< of speeding up, and again of braking [s]
  double travel_time() const;  ///< [s]
};

class ObstacleMotion {
 public:
  /// An obstacle that stays where it is.
  ObstacleMotion(const Eigen::Vector2d& position, double heading);
  /// @param legs at least one, each beginning where and when the one before has ended
  explicit ObstacleMotion(std::vector<Leg> legs);

  /// Before the first leg it rests at its start, after the last at its end. In a pause it turns
  /// from the direction of the leg behind it to that of the leg ahead.
  MotionState at(double t) const;
  bool is_static() const { return legs_.empty(); }
  double top_speed() const;  ///< never exceeded [m/s]

 private:
  MotionState rest_;  ///< of a static obstacle
  std::vector<Leg> legs_;
};

/// Draw a motion that lasts `duration` [s] for one of the group. A shuttle's polyline may leave the
/// area: the caller checks.
/// @param area edges of the rectangle around the origin where it starts [m]
ObstacleMotion draw_motion(const ObstacleGroup& group, const Eigen::Vector2d& area,
                           double speed_scale, double duration, Random& random);

}  // namespace datasets
