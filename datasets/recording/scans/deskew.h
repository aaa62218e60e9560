#pragma once
/// Points that a moving sensor measured one after the other, as if all at once (no paper section).
#include <functional>
#include <optional>
#include <vector>

#include "ldm/types.h"

namespace datasets {

/// Rays that met nothing, as unit vectors in the sensor's frame when each was fired.
struct TimedRays {
  std::vector<ldm::Point> rays;
  std::vector<float> delays;  ///< after the scan's time [s]; empty: all were fired at once
};

/// From farther than this from where the sensor is at the scan's time, a ray is left out: rays of a
/// scan start at one point [m].
inline constexpr float kFarthestRay = 0.3F;

/// Moves each point, and turns each ray, from the sensor's frame when it was measured to that of
/// the scan's time. Points that are not finite stay so.
/// @param delays of the points after that time [s]; those of rays lie between the first and last
/// @param sensor_at T_world_sensor at a delay; asked for delays in their order, 5 ms apart or less,
///   between which the motion is taken as a straight line
/// @return false, and some points may have been moved, if there is no pose at one of them
bool deskew(const std::vector<float>& delays, const ldm::Pose& T_world_sensor,
            const std::function<std::optional<ldm::Pose>(double)>& sensor_at,
            std::vector<ldm::Point>& points, TimedRays& rays);

}  // namespace datasets
