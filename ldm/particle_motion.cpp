#include "ldm/particle_motion.h"

#include <algorithm>
#include <cmath>

namespace ldm {

ParticleMotion::ParticleMotion(const RingIndex& index, int fraction_bits, double voxels_per_mps)
    : fraction_bits_(fraction_bits), gone_(static_cast<std::int32_t>(index.count())) {
  const Eigen::Vector3i& n = index.window().size;
  const Eigen::Vector3i& origin = index.origin_slot();
  extent_ = Lanes{n.x(), n.y(), n.z(), 1} << fraction_bits;
  origin_ = Lanes{origin.x(), origin.y(), origin.z(), 0} << fraction_bits;
  stride_ = Lanes{1, n.x(), n.x() * n.y(), 0};
  // A step of 15 bits: its product with any velocity fits an int. It errs by at most 2^-15 of the
  // displacement: two quanta of position for a particle that crosses the whole map at once.
  constexpr int kStepBits = 15;
  constexpr double kLongestStep = (1 << kStepBits) - 1;  // minutes and more
  const double step = voxels_per_mps * std::ldexp(Particle::kVelocityQuantum, fraction_bits);
  int exponent = 0;
  std::frexp(step, &exponent);
  shift_ = std::clamp(kStepBits - exponent, 0, 30);
  step_ = all_lanes(
      static_cast<std::int32_t>(std::lround(std::min(std::ldexp(step, shift_), kLongestStep))));
  half_ = all_lanes(shift_ > 0 ? 1 << (shift_ - 1) : 0);
}

}  // namespace ldm
