#pragma once
/// Where around a spinning LiDAR a recording has no measurements: what was lost, or is missing of a
/// turn that it cuts short, is not what met nothing (no paper section).
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "datasets/recording/rays/ray_angles.h"

namespace datasets {

/// Azimuths as those of RayAngles, to a 20th of a degree; at first none is lost.
class LostAzimuths {
 public:
  /// All that the arc from `first` on meets, `length` long [rad], in the direction from x to y.
  void add(double first, double length) {
    if (bins_.empty()) bins_.assign(kBins, 0);
    const auto begin = static_cast<std::int64_t>(std::floor(first / kBin));
    const auto end = static_cast<std::int64_t>(std::floor((first + length) / kBin));
    for (std::int64_t i = begin; i <= end && i - begin < kBins; ++i) {
      bins_[static_cast<std::size_t>((i % kBins + kBins) % kBins)] = 1;
    }
  }
  bool contains(double azimuth) const {
    if (bins_.empty()) return false;
    const auto i = static_cast<std::int64_t>(std::floor(azimuth / kBin));
    return bins_[static_cast<std::size_t>((i % kBins + kBins) % kBins)] != 0;
  }
  void clear() { bins_.clear(); }

 private:
  static constexpr std::int64_t kBins = 7200;
  static constexpr double kBin = 2 * std::numbers::pi / kBins;  // [rad]

  std::vector<std::uint8_t> bins_;
};

}  // namespace datasets
