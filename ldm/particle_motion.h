#pragma once
/// How particles move on: the noise of their velocities, their motion, and the loop over them:
/// paper Eq. (4), (5).
#include <array>
#include <cstddef>
#include <cstdint>

#include "ldm/machine/bricks.h"
#include "ldm/machine/lanes.h"
#include "ldm/machine/random.h"
#include "ldm/parameters.h"
#include "ldm/particle.h"
#include "ldm/ring_buffer.h"

namespace ldm {

/// Draws of N(0, Sigma), Sigma diagonal, in Particle::kVelocityQuantum.
///
/// A draw is the sum of two vectors of a table, each named by 11 random bits: two loads for all
/// three axes, one hash for two particles, no logarithm, and the same integers on every machine.
///
/// On each axis the entries are those of N(0, sigma^2 / 2) at 2048 equally likely points, scaled so
/// that their variance is right but for rounding; sums reach +-4.9 sigma. In which order differs
/// from axis to axis: entry i is point i of a lattice in the unit cube (N. M. Korobov, 1959), which
/// is centred, so the mirror image of an entry is one as well. Odd moments vanish. Two axes have a
/// correlation below 3e-4 (sigma from 0.05 m/s on; below, rounding adds to it), and mixed fourth
/// moments of a draw differ by up to 0.02 from those of independent axes.
class VelocityNoise {
 public:
  static constexpr int kBits = 11;  ///< that name an entry
  static constexpr std::size_t kSize = std::size_t{1} << kBits;

  /// Requires sigma_xy and sigma_z of 0 to 3 m/s (parameters.h): sums of entries fit 16 bits.
  explicit VelocityNoise(const ParticleParameters& particles);

  /// sigma of a pair. The highest 11 bits of each quarter of `bits` name an entry: those of the
  /// lower two are for the first particle, of the upper two for the second.
  Int16x8 draw(std::uint64_t bits) const { return entries<0, 2>(bits) + entries<1, 3>(bits); }
  /// v_k = v_{k-1} + sigma of a pair; saturates.  Eq. (4)
  static Int16x8 changed(const Int16x8& v, const Int16x8& sigma) {
    return saturating_sum(v, sigma);
  }
  /// The same of one particle, with a draw of the lower 32 bits.
  void change(Particle& p, std::uint64_t bits) const {
    const Int16x8 v = changed(Int16x8{p.vx, p.vy, p.vz}, draw(bits));
    p.vx = v[0];
    p.vy = v[1];
    p.vz = v[2];
  }
  /// The entries: x, y, z, 0 in 16 bits each.
  const std::array<std::int64_t, kSize>& table() const { return table_; }

 private:
  /// x, y, z, 0 of the entry that a quarter names in lanes 0 to 3, of another in 4 to 7.
  template <int kFirst, int kSecond>
  Int16x8 entries(std::uint64_t bits) const {
    const auto named_by = [&](int quarter) {
      return table_[bits >> (16 * quarter + 16 - kBits) & (kSize - 1)];
    };
    return reinterpret_cast<Int16x8>(Int64x2{named_by(kFirst), named_by(kSecond)});
  }

  std::array<std::int64_t, kSize> table_;
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

  /// What all moves have in common, for pairs.
  struct Constants {
    UInt16x8 extent, origin;  // of the window
    UInt16x8 highest;         // position in it
    Int16x8 step;             // position units per velocity unit, times 2^(15 - doublings)
    int doublings = 0;        // 0 unless a velocity unit moves by more than a position unit
    int fraction_bits;
    Int16x8 row_stride;    // slots from voxel to voxel along x and y; 1 along z, in layers
    Int32x4 layer_stride;  // slots from layer to layer
    Int32x4 gone;
  };
  const Constants& constants() const { return constants_; }
  /// What `move` gives for a pair out of the map: the number of slots.
  const Int32x4& gone() const { return constants_.gone; }
  /// x_k = x_{k-1} + dt v_k of a pair in the map, modulo the map [voxels / 2^fraction_bits], by
  /// velocities in Particle::kVelocityQuantum. Slots, in lanes 0 and 2; the number of slots, and a
  /// position without meaning, where that is out of the map. Errs by a quantum of the position, or
  /// by less than twice that of the velocity times dt if that is more.  Eq. (5)
  Int32x4 move(UInt16x8& position, const Int16x8& velocity) const {
    const Constants& c = constants_;
    Int16x8 way = rounded_product(velocity, c.step);
    for (int i = 0; i < c.doublings; ++i) way = saturating_sum(way, way);
    const UInt16x8 before = position - c.origin;
    const UInt16x8 from_lowest = lower(before, before + c.extent) + reinterpret_cast<UInt16x8>(way);
    const auto inside = lower(from_lowest, c.highest) == from_lowest;
    const UInt16x8 moved = from_lowest + c.origin;
    position = lower(moved, moved - c.extent);
    const auto voxel = reinterpret_cast<Int16x8>(position >> c.fraction_bits);
    const Int32x4 parts = sum_of_products(voxel, c.row_stride) * c.layer_stride;
    const Int32x4 slots = parts + __builtin_shufflevector(parts, parts, 1, 1, 3, 3);
    const auto all_inside = reinterpret_cast<Int32x4>(reinterpret_cast<Int64x2>(inside) == -1);
    return (slots & all_inside) | (c.gone & ~all_inside);
  }

 private:
  Constants constants_;
};

/// What changes the velocities of particles, moves them and counts them by slot.
///
/// From the hash of the noise to the count, each number of a particle waits for the one before. So
/// noise is drawn one step ahead, and counts follow one step behind: the processor works on three
/// steps at a time.
struct PredictionPass {
  Particle* particles;
  SparseNumbers::Writer count;  ///< per slot, and one for those that are gone: more is added there
  const VelocityNoise& noise;
  RandomStream stream;  ///< its number i is for particles 2 i and 2 i + 1
  ParticleMotion motion;

  /// Particles [begin, end). Requires an even `begin`; an odd `end` takes in the particle there,
  /// which is counted as well.
  void move(std::size_t begin, std::size_t end) const { move_pairs(move_fours(begin, end), end); }

  /// Two at a time, on any processor.
  void move_pairs(std::size_t begin, std::size_t end) const;
  /// Four at a time on x86 processors with AVX2, with the same bits: as many of them as are whole,
  /// from the first on. The first that is left; `begin` on other processors.
  std::size_t move_fours(std::size_t begin, std::size_t end) const;
};

}  // namespace ldm
