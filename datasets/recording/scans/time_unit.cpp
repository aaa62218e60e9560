#include "datasets/recording/scans/time_unit.h"

#include <algorithm>
#include <cmath>

namespace datasets {
namespace {

std::optional<TimeUnit> above(double value, double milliseconds, double microseconds,
                              double nanoseconds) {
  if (value > nanoseconds) return TimeUnit::kNanoseconds;
  if (value > microseconds) return TimeUnit::kMicroseconds;
  if (value > milliseconds) return TimeUnit::kMilliseconds;
  return {};
}

}  // namespace

std::optional<TimeUnit> unit_other_than_seconds(const std::vector<double>& times) {
  if (times.empty()) return {};
  if (const auto unit = above(std::abs(times.front()), 1e11, 1e14, 1e17)) return unit;
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  if (steps.empty()) return {};
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return above(*middle, 30, 1e4, 1e7);
}

}  // namespace datasets
