#pragma once
/// Quantiles of numbers (no paper section).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace experiments {

/// The smallest of `values` that at least `share` (above 0, at most 1) of them do not exceed; none
/// of nothing.
inline std::optional<double> quantile(std::vector<double> values, double share) {
  if (values.empty()) return {};
  const auto rank = std::ceil(share * static_cast<double>(values.size()) - 1e-9);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace experiments
