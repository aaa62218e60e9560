#pragma once
/// A flight by timetable: hovering, or along lines (paper Sec. 4.2.1, Fig. 11).
#include <vector>

#include "datasets/random.h"
#include "datasets/scenario/flight/flight_path.h"
#include "datasets/scenario/scenario.h"

namespace datasets {

/// The path that `uav.timetable` describes, moved as a whole by up to `uav.spread` along each axis,
/// each control point off by `uav.drift`. The spline rounds the corners of the timetable: speed
/// changes over two seconds. Requires a flight by timetable.
/// @param duration [s]
/// @param keep_outs sampled every `sample_step` [s]
/// @throws std::runtime_error naming distance and time if it comes nearer to a keep-out than
/// `uav.clearance` at any sample: the caller draws another world.
FlightPath draw_scripted_flight(const FlightDescription& uav, double duration,
                                const std::vector<KeepOut>& keep_outs, double sample_step,
                                Random& random);

}  // namespace datasets
