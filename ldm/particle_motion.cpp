#include "ldm/particle_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "ldm/particle.h"

namespace ldm {
namespace {

/// x, y, z of a pair of particles, and `rest` in the lanes that mean nothing.
UInt16x8 pair_of(const Eigen::Vector3i& v, int rest) {
  UInt16x8 lanes{};
  for (int i = 0; i < 8; ++i) lanes[i] = static_cast<std::uint16_t>(i % 4 < 3 ? v[i % 4] : rest);
  return lanes;
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
  row_stride_ = reinterpret_cast<Int16x8>(pair_of({1, n.x(), 1}, 0));
  layer_stride_ = Int32x4{1, n.x() * n.y(), 1, n.x() * n.y()};
  const auto gone = static_cast<std::int32_t>(index.count());
  gone_ = Int32x4{gone, gone, gone, gone};

  double step = voxels_per_mps * std::ldexp(Particle::kVelocityQuantum, fraction_bits);
  constexpr int kMostDoublings = 15;  // one velocity quantum crosses the whole map
  while (step > 1 && doublings_ < kMostDoublings) {
    step /= 2;
    ++doublings_;
  }
  // Doubled, a way may saturate to 2^15 - 1: even from the lowest position that is out of the map.
  const int margin = doublings_ > 0 ? 2 : 1;
  highest_ = pair_of(extent.array() - margin, -1);  // nothing is out of the largest there is
  constexpr double kOne = 1 << 15;
  const auto rounded = static_cast<std::int16_t>(std::lround(std::min(step * kOne, kOne - 1)));
  step_ = Int16x8{} + rounded;
}

}  // namespace ldm
