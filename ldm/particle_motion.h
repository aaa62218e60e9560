#pragma once
/// How a particle moves on: paper Eq. (5).
#include "ldm/machine/lanes.h"
#include "ldm/ring_buffer.h"

namespace ldm {

/// Motion by dt in the window of a map, in fixed point.
class ParticleMotion {
 public:
  /// Fraction bits of a position that fits 15 bits for any voxel of a map of so many: the sixteenth
  /// holds what is out of the map.
  static int fraction_bits(const Eigen::Vector3i& voxels);

  /// @param fraction_bits of a position, as of the function
  /// @param voxels_per_mps dt / resolution, not negative: voxels that 1 m/s covers
  ParticleMotion(const RingIndex& index, int fraction_bits, double voxels_per_mps);

  /// What `move` gives for a pair out of the map: the number of slots.
  const Int32x4& gone() const { return gone_; }
  /// x_k = x_{k-1} + dt v_k of a pair in the map, modulo the map [voxels / 2^fraction_bits], by
  /// velocities in Particle::kVelocityQuantum. Slots, in lanes 0 and 2; the number of slots, and a
  /// position without meaning, where that is out of the map. Errs by a quantum of the position, or
  /// by less than twice that of the velocity times dt if that is more.  Eq. (5)
  Int32x4 move(UInt16x8& position, const Int16x8& velocity) const {
    Int16x8 way = rounded_product(velocity, step_);
    for (int i = 0; i < doublings_; ++i) way = saturating_sum(way, way);
    const UInt16x8 before = position - origin_;
    const UInt16x8 from_lowest = lower(before, before + extent_) + reinterpret_cast<UInt16x8>(way);
    const auto inside = lower(from_lowest, highest_) == from_lowest;
    const UInt16x8 moved = from_lowest + origin_;
    position = lower(moved, moved - extent_);
    const auto voxel = reinterpret_cast<Int16x8>(position >> fraction_bits_);
    const Int32x4 parts = sum_of_products(voxel, row_stride_) * layer_stride_;
    const Int32x4 slots = parts + __builtin_shufflevector(parts, parts, 1, 1, 3, 3);
    const auto all_inside = reinterpret_cast<Int32x4>(reinterpret_cast<Int64x2>(inside) == -1);
    return (slots & all_inside) | (gone_ & ~all_inside);
  }

 private:
  friend class MotionOfFours;
  UInt16x8 extent_, origin_;  // of the window
  UInt16x8 highest_;          // position in it
  Int16x8 step_;              // position units per velocity unit, times 2^(15 - doublings_)
  int doublings_ = 0;         // 0 unless a velocity unit moves by more than a position unit
  int fraction_bits_;
  Int16x8 row_stride_;    // slots from voxel to voxel along x and y; 1 along z, in layers
  Int32x4 layer_stride_;  // slots from layer to layer
  Int32x4 gone_;
};

}  // namespace ldm
