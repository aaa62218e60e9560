#pragma once
/// What changes the velocities of particles: paper Eq. (4).
#include <array>
#include <cstddef>
#include <cstdint>

#include "ldm/machine/lanes.h"
#include "ldm/parameters.h"
#include "ldm/particle.h"

namespace ldm {

/// Draws of N(0, Sigma), Sigma diagonal, in Particle::kVelocityQuantum.
///
/// A draw is the sum of two vectors of a table, each named by 11 random bits: two loads for all
/// three axes, one hash for two particles, no logarithm, and the same integers on every machine.
/// `Particles::predict` takes 0.7 of the time it takes with a table for each axis.
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

 private:
  friend class NoiseOfFours;
  static constexpr std::size_t kSize = std::size_t{1} << kBits;

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

}  // namespace ldm
