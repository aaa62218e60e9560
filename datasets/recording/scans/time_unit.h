#pragma once
/// In what unit the times of a text file are (no paper section).
#include <optional>
#include <string_view>
#include <vector>

namespace datasets {

enum class TimeUnit { kSeconds, kMilliseconds, kMicroseconds, kNanoseconds };
inline constexpr std::string_view kTimeUnitNames[] = {"s", "ms", "us", "ns"};

/// One of that unit [s].
constexpr double seconds_in(TimeUnit unit) {
  constexpr double kSeconds[] = {1, 1e-3, 1e-6, 1e-9};
  return kSeconds[static_cast<int>(unit)];
}

/// What times of scans or poses, in their order, cannot be seconds for: no clock is there yet
/// (1e11 s are 3169 years), or half of the steps are of more than 30 s.
/// @return the unit they look like; none if they may be seconds
std::optional<TimeUnit> unit_other_than_seconds(const std::vector<double>& times);

}  // namespace datasets
