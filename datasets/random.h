#pragma once
/// Random numbers of the simulator: the same seed gives the same bits in any order.
#include <cmath>
#include <cstdint>
#include <numbers>

namespace datasets {

/// SplitMix64's finaliser (Steele, Lea and Flood, OOPSLA 2014): every input bit reaches every
/// output bit.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Random bits of a counter: independent streams for different keys.
constexpr std::uint64_t random_bits(std::uint64_t key, std::uint64_t counter) {
  return mixed(mixed(key) + 0x9e3779b97f4a7c15ULL * (counter + 1));
}

/// In (0, 1), never an end.
constexpr double uniform_of(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

/// Standard normal variate of 64 random bits, by Box and Muller (1958).
inline double normal_of(std::uint64_t bits) {
  const double radius = std::sqrt(-2 * std::log(uniform_of(bits)));
  return radius * std::cos(2 * std::numbers::pi * uniform_of(mixed(~bits)));
}

/// A value drawn uniformly between two bounds, both allowed.
struct Interval {
  double min = 0;
  double max = 0;
};

/// A stream of draws.
class Random {
 public:
  explicit Random(std::uint64_t key) : key_(key) {}

  std::uint64_t bits() { return random_bits(key_, counter_++); }
  double uniform(double min, double max) { return min + (max - min) * uniform_of(bits()); }
  double uniform(const Interval& interval) { return uniform(interval.min, interval.max); }

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace datasets
