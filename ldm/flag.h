#pragma once
/// What one scan says of a voxel, in a byte: paper Sec. 3.3.2.
#include <cstdint>

namespace ldm {

/// One byte a voxel; where two rays disagree, the larger flag wins: a hit beats a crossing, a
/// crossing beats a shadow, and of two shadows the one nearer to its obstacle.
namespace flag {
inline constexpr std::uint8_t kNone = 0;      ///< no ray came here: out of the sensor's view
inline constexpr std::uint8_t kShadow = 253;  ///< 1..253: behind an obstacle, 253 just behind it
inline constexpr std::uint8_t kFree = 254;
inline constexpr std::uint8_t kOccupied = 255;
/// A shadow flag falls by one each half voxel behind the obstacle; 1 means 126 voxels or more.
inline constexpr float kStepsPerVoxel = 2;
/// Distance behind the obstacle that a shadow flag stands for [voxels].
inline float shadow_distance(std::uint8_t f) {
  return static_cast<float>(kShadow - f) / kStepsPerVoxel;
}
}  // namespace flag

}  // namespace ldm
