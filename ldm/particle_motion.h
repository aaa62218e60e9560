#pragma once
/// How a particle changes its velocity and moves on: paper Eq. (4), (5).
#include <algorithm>
#include <cstdint>

#include "ldm/lanes.h"
#include "ldm/parameters.h"
#include "ldm/particle.h"
#include "ldm/random.h"
#include "ldm/ring_buffer.h"

namespace ldm {

/// The noise of a particle's velocity in one frame.
class VelocityNoise {
 public:
  explicit VelocityNoise(const ParticleParameters& particles)
      : xy_(particles.sigma_xy / Particle::kVelocityQuantum),
        z_(particles.sigma_z / Particle::kVelocityQuantum) {}

  /// v_k = v_{k-1} + sigma of a pair [Particle::kVelocityQuantum], each from 36 random bits;
  /// saturates.  Eq. (4)
  Int16x8 changed(const Int16x8& v, std::uint64_t first, std::uint64_t second) const {
    return saturating_sum(v, Int16x8{x(first), y(first), z(first), 0,  //
                                     x(second), y(second), z(second), 0});
  }
  /// The same of one particle.
  void change(Particle& p, std::uint64_t bits) const {
    p.vx = sum(p.vx, x(bits));
    p.vy = sum(p.vy, y(bits));
    p.vz = sum(p.vz, z(bits));
  }

 private:
  std::int16_t x(std::uint64_t bits) const { return xy_(bits); }
  std::int16_t y(std::uint64_t bits) const { return xy_(bits >> NormalTable::kBits); }
  std::int16_t z(std::uint64_t bits) const { return z_(bits >> 2 * NormalTable::kBits); }
  static std::int16_t sum(int a, int b) {
    return static_cast<std::int16_t>(std::clamp(a + b, INT16_MIN, INT16_MAX));
  }

  NormalTable xy_, z_;
};

/// Motion by dt in the window of a map, in fixed point.
class ParticleMotion {
 public:
  /// Fraction bits of a position that fits 15 bits for any voxel of a map of so many: the sixteenth
  /// holds what is out of the map.
  static int fraction_bits(const Eigen::Vector3i& voxels);

  /// @param fraction_bits of a position, as of the function
  /// @param voxels_per_mps dt / resolution, not negative: voxels that 1 m/s covers
  ParticleMotion(const RingIndex& index, int fraction_bits, double voxels_per_mps);

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
