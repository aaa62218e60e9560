#include "ldm/velocity_noise.h"

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

}  // namespace ldm
