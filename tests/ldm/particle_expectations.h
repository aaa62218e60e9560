#pragma once
/// What must be true of samples of particles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "tests/ldm/particle_filter.h"

namespace ldm {

/// The sample could come from N(mean, diag(sigma)^2) with independent axes: five standard errors.
inline void expect_normal(const std::vector<Eigen::Vector3d>& sample, const Eigen::Vector3d& mean,
                          const Eigen::Vector3d& sigma) {
  const Moments moments(sample);
  const double error = 5 / std::sqrt(static_cast<double>(sample.size()));
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(moments.mean[a], mean[a], error * sigma[a] + 1e-4) << "axis " << a;
    for (int b = 0; b <= a; ++b) {
      const double variance = a == b ? sigma[a] * sigma[a] : 0;
      EXPECT_NEAR(moments.covariance(a, b), variance, 1.5 * error * sigma[a] * sigma[b] + 1e-6)
          << "axes " << a << ", " << b;
    }
  }
}

/// The sample could be spread evenly over the box: counts in its 4 x 4 x 4 parts, chi-squared with
/// 63 degrees of freedom.
inline void expect_even(const std::vector<Eigen::Vector3d>& sample, const Eigen::Vector3d& low,
                        const Eigen::Vector3d& high) {
  std::array<int, 64> counts{};
  for (const Eigen::Vector3d& x : sample) {
    const Eigen::Array3d share = (x - low).array() / (high - low).array();
    ASSERT_TRUE((share >= 0).all() && (share < 1).all()) << x.transpose();
    const Eigen::Array3i part = (4 * share).cast<int>();
    ++counts[static_cast<std::size_t>(part.x() + 4 * (part.y() + 4 * part.z()))];
  }
  const double expected = static_cast<double>(sample.size()) / 64;
  double chi_squared = 0;
  for (const int count : counts) chi_squared += std::pow(count - expected, 2) / expected;
  EXPECT_LT(chi_squared, 63 + 5 * std::sqrt(2 * 63));
  EXPECT_GT(chi_squared, 63 - 5 * std::sqrt(2 * 63));
}

/// After resampling: every particle stands in the voxel of its slot, in the window, sorted by slot,
/// and in_slot finds each of them.
inline void expect_in_order(const ParticleFilter& filter, double resolution) {
  const RingIndex& index = filter.log_odds.index();
  std::size_t before = 0;
  std::size_t found = 0;
  for (const Particle& p : filter.particles.all()) {
    const VoxelIndex voxel = voxel_at(filter.position(p), resolution);
    ASSERT_TRUE(index.window().contains(voxel)) << voxel.transpose();
    ASSERT_EQ(p.slot, index.slot(voxel));
    ASSERT_LE(before, p.slot);
    before = p.slot;
  }
  for (std::size_t slot = 0; slot < index.count(); ++slot) {
    for (const Particle& p : filter.particles.in_slot(slot)) {
      ASSERT_EQ(p.slot, slot);
      ++found;
    }
  }
  EXPECT_EQ(found, filter.particles.all().size());
}

}  // namespace ldm
