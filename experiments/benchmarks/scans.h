#pragma once
/// Scans of a flight among 20 obstacles, in memory before anything is timed (paper Sec. 4.1.1).
#include <cstdint>
#include <map>
#include <vector>

#include "datasets/scenario/scenario.h"
#include "experiments/benchmarks/configuration.h"
#include "ldm/types.h"

namespace benchmarks {

/// Scenario 3 with 20 obstacles, 9 of them moving, seen by a LiDAR of that pattern.
datasets::Scenario flight_scenario(const Pattern& pattern);
inline constexpr std::uint64_t kFlightSeed = 1;

/// Every pattern sees the same flight.
class Scans {
 public:
  explicit Scans(std::int64_t frames) : frames_(frames) {}

  /// Simulated at the first call for a pattern. The reference stays valid.
  const std::vector<ldm::Scan>& of(const Pattern& pattern);

 private:
  std::int64_t frames_;
  std::map<Pattern, std::vector<ldm::Scan>> by_pattern_;
};

}  // namespace benchmarks
