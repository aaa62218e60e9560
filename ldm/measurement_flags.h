#pragma once
/// The measurement flag grid: ray casting a scan into occupied, free and shadow: paper Sec. 3.3.2.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ldm/machine/parallel.h"
#include "ldm/parameters.h"
#include "ldm/rays.h"
#include "ldm/types.h"

namespace ldm {

/// What one scan says of a voxel, in a byte; where two rays disagree, the larger flag wins: a hit
/// beats a crossing, a crossing beats a shadow, and of two shadows the one nearer to its obstacle.
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

/// The flags of one scan. As in Usenko et al., one ray is cast for each voxel with a return, from
/// the sensor to the voxel's centre; a return beyond the map, or none, gives a ray to the border.
class MeasurementFlags {
 public:
  /// `shadows` says whether rays go on behind their return: needed by eq. 10 alone.
  MeasurementFlags(const MapParameters& map, NoReturnRays no_returns, bool shadows,
                   std::int64_t threads = 1);

  /// Replace all flags by those of `scan` in `window`.
  /// Cost: the points, and the voxels their rays cross.
  void mark(const Scan& scan, const VoxelBox& window);

  /// In window order (see VoxelBox::index).
  std::span<const std::uint8_t> flags() const {
    return std::span(parts_[0].flags).first(window_.count());
  }

 private:
  /// One thread's stretch of the rays, with a grid of its own: the larger flag wins in the end.
  struct Part {
    std::vector<std::uint8_t> flags;  // and one for walks that have nowhere to go
    std::vector<VoxelIndex> hits;     // voxels with a return, each once, from the window's lowest
    std::vector<VoxelIndex> borders;  // voxels in which rays leave the map, each once
  };
  void mark_ends(const Scan& scan, int number, Part& part) const;
  void mark_ends(std::span<const Point> rays, bool for_ever, int number, Part& part) const;
  void mark_end_from_outside(const Eigen::Vector3f& direction, bool for_ever, Part& part) const;
  /// A ray ends in a voxel. Few are the first: the others are done with a look at the flag.
  void end_in(std::size_t index, std::uint8_t flag, Part& part) const {
    if (part.flags[index] < flag) first_end_in(index, flag, part);
  }
  void first_end_in(std::size_t index, std::uint8_t flag, Part& part) const;
  /// The ray to a voxel, at its beginning.
  struct FreeRay {
    Eigen::Vector3f direction;
    VoxelWalk walk;
    Eigen::Vector3i steps;  // along each axis, to the voxel
  };
  void cast(std::span<const VoxelIndex> ends, bool hit, Part& part) const;
  std::optional<FreeRay> ray_to(const VoxelIndex& end) const;
  void cast_shadow(const FreeRay& ray, const VoxelIndex& end, Part& part) const;
  void combine();

  double resolution_;
  bool use_no_returns_;
  bool shadows_;
  VoxelBox window_;
  Eigen::Matrix3f R_window_sensor_;  // times voxels per metre
  Eigen::Vector3f sensor_;           // in voxels from the window's lowest corner
  bool sensor_inside_ = true;        // the window
  Parallel parallel_;
  std::vector<Part> parts_;
};

}  // namespace ldm
