#pragma once
/// Labels of the observations in a recorded log (docs/log-format.md).
#include <cstdint>
#include <cstdio>
#include <string>

namespace datasets {

inline constexpr char kLidarLabel[] = "lidar";
inline constexpr char kUavLabel[] = "uav";
inline constexpr char kHitsLabel[] = "noise_free_hits";

inline std::string object_label(std::int32_t id) {
  char label[32];
  std::snprintf(label, sizeof label, "object_%02d", id);
  return label;
}

}  // namespace datasets
