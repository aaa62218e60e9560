#pragma once
/// What is measured: subjects, sizes and threads (speed of paper Sec. 4.1.2).
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace benchmarks {

/// Rays of one scan.
struct Pattern {
  std::int64_t channels = 16;
  std::int64_t azimuths = 1024;

  auto operator<=>(const Pattern&) const = default;
};

struct Configuration {
  /// A method of experiments/method/methods.cpp, or one of the names below.
  std::string subject;
  int edge = 0;                ///< voxels along each axis of the map; 0: no map
  std::int64_t particles = 0;  ///< 0: none
  Pattern pattern;
  std::int64_t threads = 1;

  /// In one word, for instance `ldm/32^3/200000/16x1024/1`.
  std::string name() const;
  bool operator==(const Configuration&) const = default;
};

inline constexpr char kLibOctomap[] = "liboctomap";     ///< baselines/liboctomap.h
inline constexpr char kBoundCache[] = "bound_cache";    ///< memory_bound.h
inline constexpr char kBoundMemory[] = "bound_memory";  ///< memory_bound.h
inline constexpr char kSimulate[] = "simulate";         ///< one scan of the simulated LiDAR

/// All configurations whose name begins with one of `prefixes`; all if there are none. What the
/// targets compare, then growth along each axis; none twice.
std::vector<Configuration> configurations(const std::vector<std::string>& prefixes);

}  // namespace benchmarks
