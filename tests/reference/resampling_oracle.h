#pragma once
/// Oracle of resampling (paper Sec. 3.4): the systematic comb, tooth by tooth (Kitagawa, 1996).
#include <cassert>
#include <cstddef>
#include <numeric>
#include <vector>

namespace reference {

/// Which particle each of `count` teeth picks: tooth i stands at (i + u) / count of the total
/// weight. Requires weights >= 0 with a positive sum, and u in [0, 1). Cost: O(count * weights).
inline std::vector<std::size_t> systematic_resampling(const std::vector<double>& weights,
                                                      std::size_t count, double u) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  assert(total > 0 && u >= 0 && u < 1);
  std::vector<std::size_t> picked;
  for (std::size_t i = 0; i < count; ++i) {
    const double tooth = (static_cast<double>(i) + u) / static_cast<double>(count) * total;
    std::size_t particle = 0;
    for (double sum = weights[0]; sum <= tooth && particle + 1 < weights.size();) {
      sum += weights[++particle];
    }
    // Rounding may carry the last tooth to the very end: nothing without weight is ever picked.
    while (weights[particle] == 0) --particle;
    picked.push_back(particle);
  }
  return picked;
}

}  // namespace reference
