#pragma once
/// Points that a moving sensor measured one after the other, as if all at once (no paper section).
#include <functional>
#include <optional>
#include <vector>

#include "ldm/types.h"

namespace datasets {

/// Moves each point from the sensor's frame when it was measured to that of the scan's time.
/// @param delays of the points after that time [s]
/// @param sensor_at T_world_sensor at a delay; asked for delays in their order, 5 ms apart or less,
///   between which the motion is taken as a straight line
/// @return false, and some points may have been moved, if there is no pose at one of them
bool deskew(const std::vector<float>& delays, const ldm::Pose& T_world_sensor,
            const std::function<std::optional<ldm::Pose>(double)>& sensor_at,
            std::vector<ldm::Point>& points);

}  // namespace datasets
