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

  /// v_k = v_{k-1} + sigma [Particle::kVelocityQuantum], from 36 random bits.  Eq. (4)
  Lanes changed(const Lanes& v, std::uint64_t bits) const {
    const Lanes sum = v + Lanes{xy_(bits), xy_(bits >> NormalTable::kBits),
                                z_(bits >> 2 * NormalTable::kBits), 0};
    const Lanes low = all_lanes(INT16_MIN);
    const Lanes high = all_lanes(INT16_MAX);
    const Lanes at_most = sum > high ? high : sum;
    return at_most < low ? low : at_most;
  }

 private:
  NormalTable xy_, z_;
};

/// Motion by dt in the window of a map, in fixed point.
class ParticleMotion {
 public:
  /// @param fraction_bits of a position
  /// @param voxels_per_mps dt / resolution: voxels that 1 m/s covers
  ParticleMotion(const RingIndex& index, int fraction_bits, double voxels_per_mps);

  /// x_k = x_{k-1} + dt v_k, modulo the map. Its slot; the number of slots, and a position without
  /// meaning, if that is out of the map.  Eq. (5)
  std::uint32_t move(Lanes& position, const Lanes& velocity) const {
    const Lanes before = position - origin_;
    const Lanes from_lowest =
        unsigned_min(before, before + extent_) + ((velocity * step_ + half_) >> shift_);
    const Lanes inside = unsigned_min(from_lowest, extent_ - 1) == from_lowest;
    const Lanes moved = from_lowest + origin_;
    position = unsigned_min(unsigned_min(moved, moved - extent_), extent_ - 1);
    const Lanes part = (position >> fraction_bits_) * stride_ + (~inside & kFar);
    return static_cast<std::uint32_t>(std::min(part[0] + part[1] + part[2], gone_));
  }

 private:
  static constexpr std::int32_t kFar = 1 << 28;  // more than any slot; three of them still fit
  Lanes extent_, origin_;                        // of the window
  Lanes stride_;                                 // slots from voxel to voxel
  Lanes step_, half_;  // position units per velocity unit, and a half, both times 2^shift
  int shift_;
  int fraction_bits_;
  std::int32_t gone_;
};

}  // namespace ldm
