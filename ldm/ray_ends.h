#pragma once
/// In which voxels the rays of a scan end: for paper Sec. 3.3.2.
#include <array>
#include <cstdint>
#include <span>

#include "ldm/flag.h"
#include "ldm/types.h"

namespace ldm {

/// Ends of up to kMost rays at a time. Plain arrays and a loop without branches: the compiler turns
/// it into vectors, four rays or more at once, which takes a third of the time of ray after ray.
class RayEnds {
 public:
  static constexpr std::size_t kMost = 64;

  /// @param sensor origin of the rays, inside the box (0, size) of voxels
  /// @param turn from the frame of `rays` to the box's axes, times voxels per metre
  RayEnds(const Eigen::Vector3f& sensor, const Eigen::Matrix3f& turn, const Eigen::Vector3i& size)
      : sensor_(sensor), turn_(turn), size_(size) {}

  /// Ray i goes from the sensor to rays[i], or on for ever. At most kMost.
  void find(std::span<const Point> rays, bool for_ever);

  /// What the last voxel of ray i is: flag::kOccupied if it ends in the box, flag::kFree if it
  /// leaves the box there, flag::kNone for a ray without a direction.
  std::uint8_t flag(std::size_t i) const { return static_cast<std::uint8_t>(flag_[i]); }
  /// That voxel: its row-major position in the box, x fastest.
  std::size_t index(std::size_t i) const { return static_cast<std::size_t>(index_[i]); }

 private:
  Eigen::Vector3f sensor_;
  Eigen::Matrix3f turn_;
  Eigen::Vector3i size_;
  std::array<std::int32_t, kMost> flag_, index_;
};

}  // namespace ldm
