#include "ldm/particle_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

namespace ldm {
namespace {

/// z with Phi(z) = p, for 0.5 <= p < 1: Newton's method on the distribution function.
double normal_quantile(double p, double start) {
  double z = start;
  for (int i = 0; i < 60; ++i) {
    const double value = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    const double slope = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
    const double step = (value - p) / slope;
    z -= step;
    if (std::abs(step) < 1e-14) break;
  }
  return z;
}

/// N(0, 1) at `size` equally likely points, ascending; the sum of their squares is `size`.
std::vector<double> normal_points(std::size_t size) {
  std::vector<double> z(size);
  double previous = 0;
  double sum_of_squares = 0;
  for (std::size_t i = size / 2; i < size; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(size);
    z[i] = previous = normal_quantile(p, previous);
    sum_of_squares += 2 * z[i] * z[i];
  }
  const double deviation = std::sqrt(sum_of_squares / static_cast<double>(size));
  for (std::size_t i = size / 2; i < size; ++i) {
    z[i] /= deviation;
    z[size - 1 - i] = -z[i];
  }
  return z;
}

/// x, y, z of a pair of particles, and `rest` in the lanes that mean nothing.
UInt16x8 pair_of(const Eigen::Vector3i& v, int rest) {
  UInt16x8 lanes{};
  for (int i = 0; i < 8; ++i) lanes[i] = static_cast<std::uint16_t>(i % 4 < 3 ? v[i % 4] : rest);
  return lanes;
}

void count_slots(const Int32x4& slots, const SparseNumbers::Writer& count) {
  count.add_one(static_cast<std::uint32_t>(slots[0]));
  count.add_one(static_cast<std::uint32_t>(slots[2]));
}

}  // namespace

VelocityNoise::VelocityNoise(const ParticleParameters& particles) {
  static const std::vector<double> points = normal_points(kSize);
  // Of the generators whose axes correlate below 3e-4, the one of the smallest mixed fourth
  // moments.
  constexpr std::size_t kGenerator = 625;
  const std::array<double, 3> sigma{particles.sigma_xy, particles.sigma_xy, particles.sigma_z};
  for (std::size_t i = 0; i < kSize; ++i) {
    std::array<std::int16_t, 4> entry{};
    std::size_t step = 1;  // of the lattice along the axis
    for (std::size_t axis = 0; axis < 3; ++axis, step *= kGenerator) {
      const std::size_t point = (step * i + (step - 1) / 2) % kSize;  // step (i + 1/2) - 1/2
      const double units = sigma[axis] / std::numbers::sqrt2 / Particle::kVelocityQuantum;
      entry[axis] = static_cast<std::int16_t>(std::lround(units * points[point]));
    }
    std::memcpy(&table_[i], entry.data(), sizeof entry);
  }
}

int ParticleMotion::fraction_bits(const Eigen::Vector3i& voxels) {
  return 15 - static_cast<int>(std::bit_width(static_cast<unsigned>(voxels.maxCoeff() - 1)));
}

ParticleMotion::ParticleMotion(const RingIndex& index, int fraction_bits, double voxels_per_mps) {
  constants_.fraction_bits = fraction_bits;
  const Eigen::Vector3i& n = index.window().size;
  const Eigen::Vector3i extent = n * (1 << fraction_bits);
  constants_.extent = pair_of(extent, 0);
  constants_.origin = pair_of(index.origin_slot() * (1 << fraction_bits), 0);
  constants_.row_stride = reinterpret_cast<Int16x8>(pair_of({1, n.x(), 1}, 0));
  constants_.layer_stride = Int32x4{1, n.x() * n.y(), 1, n.x() * n.y()};
  const auto gone = static_cast<std::int32_t>(index.count());
  constants_.gone = Int32x4{gone, gone, gone, gone};

  double step = voxels_per_mps * std::ldexp(Particle::kVelocityQuantum, fraction_bits);
  constexpr int kMostDoublings = 15;  // one velocity quantum crosses the whole map
  while (step > 1 && constants_.doublings < kMostDoublings) {
    step /= 2;
    ++constants_.doublings;
  }
  // Doubled, a way may saturate to 2^15 - 1: even from the lowest position that is out of the map.
  const int margin = constants_.doublings > 0 ? 2 : 1;
  constants_.highest =
      pair_of(extent.array() - margin, -1);  // nothing is out of the largest there is
  constexpr double kOne = 1 << 15;
  const auto rounded = static_cast<std::int16_t>(std::lround(std::min(step * kOne, kOne - 1)));
  constants_.step = Int16x8{} + rounded;
}

void PredictionPass::move_pairs(std::size_t begin, std::size_t end) const {
  // A copy: nothing that the loop writes can be a part of it, so it stays in registers.
  const PredictionPass pass = *this;
  Int16x8 sigma = pass.noise.draw(pass.stream.bits(begin / 2));
  Int32x4 counted = pass.motion.gone();
  for (std::size_t i = begin; i < end; i += 2) {
    Particle* const at = pass.particles + i;
    ParticlePair pair(at);
    pair.velocity = VelocityNoise::changed(pair.velocity, sigma);
    sigma = pass.noise.draw(pass.stream.bits(i / 2 + 1));
    count_slots(counted, pass.count);
    counted = pass.motion.move(pair.position, pair.velocity);
    pair.store(counted, at);
  }
  count_slots(counted, pass.count);
}

}  // namespace ldm
