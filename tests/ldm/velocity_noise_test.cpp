/// Draws of the noise of eq. (4).
#include "ldm/particle_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <vector>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr int kLowest = INT16_MIN;
constexpr int kHighest = INT16_MAX;
constexpr std::uint64_t kEntries = std::uint64_t{1} << VelocityNoise::kBits;

ParticleParameters with_sigma(double xy, double z) {
  ParticleParameters parameters;
  parameters.sigma_xy = xy;
  parameters.sigma_z = z;
  return parameters;
}

/// Bits that name these entries: two for a particle, two for the other of its pair.
std::uint64_t bits_of(std::uint64_t i, std::uint64_t j, std::uint64_t k, std::uint64_t l) {
  return i << 5 | j << 21 | k << 37 | l << 53;
}

/// What `bits` do to a particle at rest, and to the other of its pair [Particle::kVelocityQuantum].
std::array<Eigen::Vector3i, 2> draw(const VelocityNoise& noise, std::uint64_t bits) {
  const Int16x8 v = noise.draw(bits);
  return {Eigen::Vector3i(v[0], v[1], v[2]), Eigen::Vector3i(v[4], v[5], v[6])};
}

/// Twice each entry of the table.
std::vector<Eigen::Vector3i> twice_the_entries(const VelocityNoise& noise) {
  std::vector<Eigen::Vector3i> twice;
  for (std::uint64_t i = 0; i < kEntries; ++i) {
    twice.push_back(draw(noise, bits_of(i, i, 0, 0))[0]);
  }
  return twice;
}

/// Mean over the entries of x^i y^j z^k, each in standard deviations of its axis.
double moment(const std::vector<Eigen::Vector3i>& twice, const Eigen::Array3d& sigma,
              const Eigen::Array3d& powers) {
  const Eigen::Array3d unit = sigma / Particle::kVelocityQuantum * std::numbers::sqrt2;
  double sum = 0;
  for (const Eigen::Vector3i& t : twice) {
    sum += (t.cast<double>().array() / unit).pow(powers).prod();
  }
  return sum / static_cast<double>(twice.size());
}

TEST(VelocityNoiseTest, MeanIsZeroAndVarianceIsSigmaSquared) {
  for (const double sigma : {0.0, 0.001, 0.1, 0.8, 3.0}) {
    const std::vector<Eigen::Vector3i> twice =
        twice_the_entries(VelocityNoise(with_sigma(sigma, sigma / 4)));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Array3d squares = Eigen::Array3d::Zero();
    for (const Eigen::Vector3i& t : twice) {
      sum += t.cast<double>();
      squares += t.cast<double>().array().square();
    }
    EXPECT_EQ(sum, Eigen::Vector3d::Zero());
    for (int axis = 0; axis < 3; ++axis) {
      // A draw is the sum of two entries: half the square of twice an entry, in the mean.
      const double variance = squares[axis] / 2 / static_cast<double>(kEntries);
      const double units = (axis < 2 ? sigma : sigma / 4) / Particle::kVelocityQuantum;
      EXPECT_NEAR(variance, units * units, 1e-3 * units * units + 2 * 0.25) << sigma;
    }
  }
}

TEST(VelocityNoiseTest, EntriesAreTheQuantilesOfTheNormalDistributionOnEachAxis) {
  constexpr double kSigma = 3;
  const std::vector<Eigen::Vector3i> twice =
      twice_the_entries(VelocityNoise(with_sigma(kSigma, kSigma)));
  for (int axis = 0; axis < 3; ++axis) {
    std::multiset<int> sorted;
    for (const Eigen::Vector3i& t : twice) sorted.insert(t[axis]);
    int i = 0;
    for (const int t : sorted) {
      const double z = t * Particle::kVelocityQuantum / kSigma / std::numbers::sqrt2;
      const double below = 0.5 * std::erfc(-z / std::numbers::sqrt2);
      EXPECT_NEAR(below, (i + 0.5) / static_cast<double>(kEntries), 5e-4);
      ++i;
    }
    EXPECT_NEAR(*sorted.rbegin() * Particle::kVelocityQuantum / kSigma, 4.9, 0.05);
  }
}

// 1 where all powers are even, 3 of a fourth power, 0 where one is odd. Entries may differ from
// that by twice what their sums may.
TEST(VelocityNoiseTest, MixedMomentsUpToTheFourthAreNearThoseOfIndependentAxes) {
  const Eigen::Array3d sigma(0.8, 0.8, 0.16);
  const std::vector<Eigen::Vector3i> twice =
      twice_the_entries(VelocityNoise(with_sigma(0.8, 0.16)));
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; i + j <= 4; ++j) {
      for (int k = 0; i + j + k <= 4; ++k) {
        const bool odd = (i | j | k) % 2 == 1;
        const bool fourth = i == 4 || j == 4 || k == 4;
        const double tolerance = i + j + k == 2 ? 3e-4 : 0.04;
        EXPECT_NEAR(moment(twice, sigma, Eigen::Array3i(i, j, k).cast<double>()),
                    odd      ? 0
                    : fourth ? 3
                             : 1,
                    tolerance)
            << i << j << k;
      }
    }
  }
}

TEST(VelocityNoiseTest, IsTheSumOfTheEntriesThatItsBitsName) {
  const VelocityNoise noise(with_sigma(0.8, 0.16));
  const std::vector<Eigen::Vector3i> twice = twice_the_entries(noise);
  Random random(3);
  const auto entry = [&] {
    return static_cast<std::size_t>(uniform_int(0, static_cast<int>(kEntries) - 1, random));
  };
  for (int trial = 0; trial < 1000; ++trial) {
    const std::array<std::size_t, 4> named{entry(), entry(), entry(), entry()};
    const auto two = draw(noise, bits_of(named[0], named[1], named[2], named[3]));
    EXPECT_EQ(2 * two[0], twice[named[0]] + twice[named[1]]);
    EXPECT_EQ(2 * two[1], twice[named[2]] + twice[named[3]]);
  }
}

TEST(VelocityNoiseTest, SaturatesInsteadOfTurningAround) {
  const VelocityNoise noise(with_sigma(3, 3));
  const Int16x8 highest = Int16x8{} + static_cast<std::int16_t>(kHighest);
  const Int16x8 lowest = Int16x8{} + static_cast<std::int16_t>(kLowest);
  for (std::uint64_t i = 0; i < kEntries; ++i) {
    const std::uint64_t bits = bits_of(i, i, i, i);
    const Int16x8 noise_alone = noise.draw(bits);
    const Int16x8 high = VelocityNoise::changed(highest, noise_alone);
    const Int16x8 low = VelocityNoise::changed(lowest, noise_alone);
    for (int lane = 0; lane < 8; ++lane) {
      EXPECT_EQ(high[lane], std::min(kHighest + noise_alone[lane], kHighest));
      EXPECT_EQ(low[lane], std::max(kLowest + noise_alone[lane], kLowest));
    }
  }
}

TEST(VelocityNoiseTest, OfAPairIsThatOfEach) {
  const VelocityNoise noise(with_sigma(0.8, 0.16));
  Random random(9);
  for (int trial = 0; trial < 1000; ++trial) {
    Particle two[2]{};
    for (Particle& p : two) {
      p.vx = static_cast<std::int16_t>(uniform_int(kLowest, kHighest, random));
      p.vy = kLowest;
      p.vz = kHighest;
    }
    const std::uint64_t bits = random();
    const Int16x8 pair = VelocityNoise::changed(ParticlePair(two).velocity, noise.draw(bits));
    noise.change(two[0], bits);
    noise.change(two[1], bits >> 32);
    for (int i = 0; i < 2; ++i) {
      ASSERT_EQ(pair[4 * i], two[i].vx);
      ASSERT_EQ(pair[4 * i + 1], two[i].vy);
      ASSERT_EQ(pair[4 * i + 2], two[i].vz);
    }
  }
}

}  // namespace
}  // namespace ldm
