#include "ldm/prediction_pass.h"

namespace ldm {
namespace {

void count_slots(const Int32x4& slots, std::uint32_t* count) {
  ++count[static_cast<std::uint32_t>(slots[0])];
  ++count[static_cast<std::uint32_t>(slots[2])];
}

}  // namespace

void PredictionPass::run_pairs(std::size_t begin, std::size_t end) const {
  // A copy: nothing that the loop writes can be a part of it, so it stays in registers.
  const PredictionPass pass = *this;
  Int16x8 sigma = pass.noise.draw(pass.stream.bits(begin / 2));
  Int32x4 counted = pass.motion.gone();
  for (std::size_t i = begin; i < end; i += 2) {
    Particle* const two = pass.particles + i;
    ParticlePair pair(two);
    pair.velocity = VelocityNoise::changed(pair.velocity, sigma);
    sigma = pass.noise.draw(pass.stream.bits(i / 2 + 1));
    count_slots(counted, pass.count);
    counted = pass.motion.move(pair.position, pair.velocity);
    pair.store(counted, two);
  }
  count_slots(counted, pass.count);
}

}  // namespace ldm
