#pragma once
/// Dates with times of day, as KITTI's raw recordings have them (no paper section).
#include <optional>
#include <string_view>

namespace datasets {

/// `2011-09-26 13:02:25.594360375` as seconds since 1970, UTC; a `T` may stand for the blank, and
/// a `Z` at the end. None for anything else.
std::optional<double> seconds_of_date_time(std::string_view text);

}  // namespace datasets
