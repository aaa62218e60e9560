#pragma once
/// Directions of returns as a spinning LiDAR sees them (no paper section).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ldm/types.h"

namespace datasets {

inline constexpr float kTurn = 2 * std::numbers::pi_v<float>;  ///< [rad]

/// Of one return, in the sensor's frame.
struct RayAngles {
  float azimuth = 0;  ///< -pi to pi, from x to y [rad]
  float slope = 0;    ///< tangent of the elevation
  float range = 0;    ///< [m]
};

/// `a`, which is less than two turns away, as the same angle from -half a turn to half a turn
/// [rad].
inline float within_half_a_turn(float a) {
  if (a > kTurn / 2) return a - kTurn;
  return a < -kTurn / 2 ? a + kTurn : a;
}

/// As std::atan2 within 0.000002 rad, in less time.
inline float azimuth_of(float y, float x) {
  const float across = std::abs(x), along = std::abs(y);
  const float t = std::min(across, along) / std::max(across, along), s = t * t;
  // Least largest error over 0 to 1 of an odd polynomial of degree 11.
  float a =
      t * (0.99997726F +
           s * (-0.33262347F +
                s * (0.19354346F + s * (-0.11643287F + s * (0.05265332F + s * -0.01172120F)))));
  if (along > across) a = kTurn / 4 - a;
  if (x < 0) a = kTurn / 2 - a;
  return y < 0 ? -a : a;
}

/// Of all points but pixels without a return: those at 0 or not finite.
inline void angles_of(const std::vector<ldm::Point>& points, std::vector<RayAngles>& angles) {
  angles.clear();
  for (const ldm::Point& p : points) {
    const float across = p.head<2>().squaredNorm(), range = p.norm();
    if (!(across > 0) || !std::isfinite(range)) continue;
    angles.push_back({azimuth_of(p.y(), p.x()), p.z() / std::sqrt(across), range});
  }
}

}  // namespace datasets
