#pragma once
/// The loop of `Particles::predict`: paper Eq. (4), (5).
#include <cstddef>
#include <cstdint>

#include "ldm/particle.h"
#include "ldm/particle_motion.h"
#include "ldm/random.h"
#include "ldm/velocity_noise.h"

namespace ldm {

/// What changes the velocities of particles, moves them and counts them by slot.
///
/// From the hash of the noise to the count, each number of a particle waits for the one before. So
/// noise is drawn one step ahead, and counts follow one step behind: the processor works on three
/// steps at a time, in 0.8 of the time.
struct PredictionPass {
  Particle* particles;
  std::uint32_t* count;  ///< per slot, and one for those that are gone, to which more is added
  const VelocityNoise& noise;
  RandomStream stream;  ///< its number i is for particles 2 i and 2 i + 1
  ParticleMotion motion;

  /// Particles [begin, end). Requires an even `begin`; an odd `end` takes in the particle there,
  /// which is counted as well.
  void run(std::size_t begin, std::size_t end) const { run_pairs(run_fours(begin, end), end); }

  /// Two at a time, on any processor.
  void run_pairs(std::size_t begin, std::size_t end) const;
  /// Four at a time on x86 processors with AVX2, with the same bits in 0.73 of the time: as many
  /// of them as are whole, from the first on. The first that is left; `begin` on other processors.
  std::size_t run_fours(std::size_t begin, std::size_t end) const;
};

}  // namespace ldm
