#include "ldm/random.h"

#include <cmath>
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

/// The upper half of the table for sigma = 1, ascending.
std::vector<double> upper_quantiles(std::size_t size) {
  std::vector<double> z(size / 2);
  double previous = 0;
  double sum_of_squares = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double p = 0.5 + (static_cast<double>(i) + 0.5) / static_cast<double>(size);
    z[i] = previous = normal_quantile(p, previous);
    sum_of_squares += z[i] * z[i];
  }
  const double deviation = std::sqrt(sum_of_squares / static_cast<double>(z.size()));
  for (double& value : z) value /= deviation;
  return z;
}

}  // namespace

NormalTable::NormalTable(double sigma) {
  static const std::vector<double> upper = upper_quantiles(kSize);
  for (std::size_t i = 0; i < kSize / 2; ++i) {
    const auto value = static_cast<std::int16_t>(std::lround(sigma * upper[i]));
    values_[kSize / 2 + i] = value;
    values_[kSize / 2 - 1 - i] = static_cast<std::int16_t>(-value);
  }
}

}  // namespace ldm
