#pragma once
/// The door of every mapper: what a scan must be to be taken (see Mapper::update).
#include <optional>

#include "ldm/types.h"

namespace ldm {

/// @throws InvalidInput naming the first bad field and its value: a non-finite time, pose, point or
/// direction, a coordinate beyond 1e7 m, a matrix that is no rotation, or a time before
/// `previous_time` [s]. Cost: one pass over the points.
void check_scan(const Scan& scan, std::optional<double> previous_time);

}  // namespace ldm
