#pragma once
/// Swept parameters of a study: axes and the points they span (no paper section).
#include <string>
#include <vector>

#include "datasets/files/toml_reader.h"
#include "experiments/method/settings.h"

namespace experiments {

/// One combination of swept values; empty where nothing is swept.
using Point = Settings;

/// The points of a study's `[sweep]` table:
///
///     [sweep]
///     combine = "cross"      # or "paired": first values together, second values together, ...
///     [sweep.axes]
///     "particles.count" = [1000, 10000]
///     "scenario.sensor.range_sigma_m" = {from = 0.01, to = 0.1, steps = 4, scale = "log"}
///
/// The last axis runs fastest. A range between whole numbers has whole numbers only.
/// @throws ldm::InvalidInput on an unknown key, an empty or doubled axis value, or paired axes of
/// different lengths.
std::vector<Point> read_points(const datasets::TomlTable& sweep);

/// `name=value` for each axis, one blank between; empty for no sweep.
std::string describe(const Point& point);

}  // namespace experiments
