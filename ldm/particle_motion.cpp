#include "ldm/particle_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ldm {
namespace {

/// x, y, z of a pair of particles, and `rest` in the halves that mean nothing.
Halves pair_of(const Eigen::Vector3i& v, int rest) {
  Halves halves{};
  for (int i = 0; i < 8; ++i) halves[i] = static_cast<std::int16_t>(i % 4 < 3 ? v[i % 4] : rest);
  return halves;
}

}  // namespace

int ParticleMotion::fraction_bits(const Eigen::Vector3i& voxels) {
  return 15 - static_cast<int>(std::bit_width(static_cast<unsigned>(voxels.maxCoeff() - 1)));
}

ParticleMotion::ParticleMotion(const RingIndex& index, int fraction_bits, double voxels_per_mps)
    : fraction_bits_(fraction_bits) {
  const Eigen::Vector3i& n = index.window().size;
  const Eigen::Vector3i extent = n * (1 << fraction_bits);
  extent_ = pair_of(extent, 0);
  origin_ = pair_of(index.origin_slot() * (1 << fraction_bits), 0);
  highest_ = pair_of(extent.array() - 1, -1);  // the largest there is: nothing is out of it
  row_stride_ = pair_of({1, n.x(), 1}, 0);
  layer_stride_ = Lanes{1, n.x() * n.y(), 1, n.x() * n.y()};
  const auto gone = static_cast<std::int32_t>(index.count());
  gone_ = Lanes{gone, gone, gone, gone};

  double step = voxels_per_mps * std::ldexp(Particle::kVelocityQuantum, fraction_bits);
  constexpr int kMostDoublings = 15;  // one velocity quantum crosses the whole map
  while (step > 1 && doublings_ < kMostDoublings) {
    step /= 2;
    ++doublings_;
  }
  constexpr double kOne = 1 << 15;
  const auto rounded = static_cast<std::int16_t>(std::lround(std::min(step * kOne, kOne - 1)));
  step_ = Halves{} + rounded;
}

}  // namespace ldm
