#include "datasets/recording/rays/firing_times.h"

#include <algorithm>
#include <cmath>

namespace datasets {

FiringTimes::FiringTimes(const std::vector<ldm::Point>& points, const std::vector<float>& delays)
    : bins_(kBins), before_(kBins), after_(kBins) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ldm::Point& p = points[i];
    if (!(p.head<2>().squaredNorm() > 0) || !p.allFinite()) continue;
    const float turns = azimuth_of(p.y(), p.x()) / kTurn + 0.5F;
    Bin& bin = bins_[std::min(static_cast<std::size_t>(turns * kBins), kBins - 1)];
    bin.first = bin.used ? std::min(bin.first, delays[i]) : delays[i];
    bin.last = bin.used ? std::max(bin.last, delays[i]) : delays[i];
    bin.used = true;
  }
  if (!delays.empty()) {
    const auto [first, last] = std::minmax_element(delays.begin(), delays.end());
    longest_ = (*last - *first) / 2;
  }
  // Twice around, so that the nearest before the first bin is found as well.
  for (std::size_t k = 0, last = kBins; k < 2 * kBins; ++k) {
    if (bins_[k % kBins].used) last = k % kBins;
    before_[k % kBins] = last;
  }
  for (std::size_t k = 2 * kBins, last = kBins; k-- > 0;) {
    if (bins_[k % kBins].used) last = k % kBins;
    after_[k % kBins] = last;
  }
}

std::optional<float> FiringTimes::at(double azimuth) const {
  const double turns = azimuth / static_cast<double>(kTurn) + 0.5;
  const auto bin =
      static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(kBins)) % kBins;
  const std::size_t before = before_[bin], after = after_[bin];
  if (before == kBins) return {};
  const std::size_t gap = (after + kBins - before) % kBins;
  const std::size_t behind = (bin + kBins - before) % kBins;
  const float share = gap == 0 ? 0 : static_cast<float>(behind) / static_cast<float>(gap);
  return between(bins_[before], bins_[after], share);
}

std::optional<float> FiringTimes::between(const Bin& a, const Bin& b, float share) const {
  if (std::max(a.last, b.last) - std::min(a.first, b.first) > longest_) return {};
  return (1 - share) * (a.first + a.last) / 2 + share * (b.first + b.last) / 2;
}

}  // namespace datasets
