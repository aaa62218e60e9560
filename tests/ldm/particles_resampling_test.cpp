/// Weights of particles, and resampling by them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ldm/log_odds.h"
#include "ldm/particles.h"
#include "tests/ldm/particle_expectations.h"
#include "tests/reference/resampling_oracle.h"

namespace ldm {
namespace {

constexpr double kResolution = 0.15;

ParticleFilter filter_of(const Eigen::Vector3i& voxels, std::int64_t count, bool birth,
                         std::uint64_t seed = 1) {
  ParticleParameters parameters = particle_parameters(count, 0.8);
  parameters.birth = birth;
  parameters.min_per_voxel = 20;
  return {map_of(voxels), parameters, seed};
}

void draw_log_odds(ParticleFilter& filter, Random& random) {
  for (float& l : filter.log_odds.cells()) {
    l = uniform_int(0, 2, random) == 0 ? 0.0F : static_cast<float>(uniform(-2, 3.5, random));
  }
}

// Eq. (11)
TEST(ParticleWeightTest, PriorPlusOccupancyByHand) {
  const ParticleFilter filter = filter_of({5, 5, 5}, 1024, true);
  // In 2^-24: the prior 1/1024 is 16384, P = 1/2 is 2^23, P = 0.7 is 11744051.2.
  EXPECT_EQ(filter.particles.updated_weight(0), 16384u + 8388608u);
  EXPECT_EQ(filter.particles.updated_weight(static_cast<float>(log_odds(0.7))), 16384u + 11744051u);
  const ParticleFilter papers = filter_of({5, 5, 5}, 200000, true);
  EXPECT_EQ(papers.particles.updated_weight(0), 84u + 8388608u);  // 83.9
}

// Eq. (14)
TEST(ParticleWeightTest, NormalisedWeightIsThePartOfAllParticlesThatItClaims) {
  EXPECT_EQ(Particles::normalised(10, 0.25), 3u);  // 2.5, rounded up
  EXPECT_EQ(Particles::normalised(3, 4.125), 13u);
  // Four particles of weights 1, 1, 2, 4 share out four: 1/2, 1/2, 1 and 2 of them.
  const double claim_per_weight = 4.0 / 8 * std::ldexp(1, 30);
  EXPECT_NEAR(Particles::normalised(1, claim_per_weight), std::ldexp(1, 29), 1);
  EXPECT_NEAR(Particles::normalised(4, claim_per_weight), std::ldexp(2, 30), 1);
}

// Eq. (15)
TEST(ParticleWeightTest, TotalByHand) {
  ParticleFilter filter = filter_of({5, 5, 5}, 1000, false);
  filter.particles.predict(0, filter.log_odds.index());
  filter.particles.weigh(filter.log_odds);
  EXPECT_EQ(filter.particles.total_weight(), 1000 * 8405385ULL);  // 2^24 (1/1000 + 1/2)
}

TEST(ParticleWeightTest, TotalIsTheSumOverParticlesInTheMap) {
  Random random(1);
  for (const Eigen::Vector3i& n : map_sizes()) {
    ParticleFilter filter = filter_of(n, 3000, false);
    draw_log_odds(filter, random);
    filter.particles.predict(0.3, filter.log_odds.index());
    std::uint64_t sum = 0;
    for (const Particle& p : filter.particles.all()) {
      if (p.slot == filter.gone()) continue;
      sum += filter.particles.updated_weight(filter.log_odds.cells()[p.slot]);
    }
    filter.particles.weigh(filter.log_odds);
    EXPECT_EQ(filter.particles.total_weight(), sum);
  }
}

using State = std::array<int, 6>;
State state_of(const Particle& p) {
  return {p.x, p.y, p.z, p.vx, p.vy, p.vz};
}

TEST(ParticleResamplingTest, EachIsCopiedItsShareRoundedUpOrDown) {
  Random random(2);
  for (const Eigen::Vector3i& n : map_sizes()) {
    SCOPED_TRACE(testing::Message() << n.transpose());
    ParticleFilter filter = filter_of(n, 5000, false);
    draw_log_odds(filter, random);
    filter.particles.predict(0.2, filter.log_odds.index());
    const std::vector<Particle> before = filter.snapshot();
    filter.update();
    ASSERT_EQ(filter.particles.all().size(), 5000u);
    std::map<State, int> copies;
    for (const Particle& p : filter.particles.all()) ++copies[state_of(p)];

    const auto total = static_cast<double>(filter.particles.total_weight());
    int found = 0;
    for (const Particle& p : before) {
      const int copied = copies.contains(state_of(p)) ? copies[state_of(p)] : 0;
      if (p.slot == filter.gone()) {
        ASSERT_EQ(copied, 0);
        continue;
      }
      const auto weight =
          static_cast<double>(filter.particles.updated_weight(filter.log_odds.cells()[p.slot]));
      const double share = 5000 * weight / total;
      ASSERT_GE(copied, std::floor(share - 1e-6));
      ASSERT_LE(copied, std::ceil(share + 1e-6));
      found += copied;
    }
    EXPECT_EQ(found, 5000);  // and nobody else is there
  }
}

/// Weights of the voxels with `counts` particles each: of those, and of the ones to be born.
std::vector<double> voxel_weights(const ParticleFilter& filter,
                                  const std::vector<std::size_t>& counts,
                                  std::size_t min_per_voxel) {
  const auto n_init = static_cast<double>(filter.particles.all().size());
  const double prior = std::floor(std::ldexp(1, 24) / n_init);
  std::vector<double> weights;
  for (std::size_t slot = 0; slot < counts.size(); ++slot) {
    const float l = filter.log_odds.cells()[slot];
    const auto weight = static_cast<double>(filter.particles.updated_weight(l));
    const std::size_t births =
        l > 0 && counts[slot] < min_per_voxel ? min_per_voxel - counts[slot] : 0;
    weights.push_back(static_cast<double>(counts[slot]) * weight +
                      static_cast<double>(births) * (weight - prior));
  }
  return weights;
}

/// The comb offset u at which systematic resampling gives these counts: tooth i stands at i + u, so
/// of the claims up to S it fills the smallest whole number not below S - u. Claims are rounded up
/// by up to 3 units of 2^-31 of a particle, which moves a tooth by up to kRounding behind 40,000
/// claims.
constexpr double kRounding = 6e-5;
double comb_offset(const std::vector<double>& weights, const std::vector<std::size_t>& counts) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double teeth = std::accumulate(counts.begin(), counts.end(), 0.0);
  double lowest = 0;
  double highest = 1;
  double claimed = 0;
  double filled = 0;
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    claimed += weights[i] / total * teeth;
    filled += static_cast<double>(counts[i]);
    lowest = std::max(lowest, claimed - filled);
    highest = std::min(highest, claimed - filled + 1);
  }
  EXPECT_LT(lowest, highest + kRounding) << "no comb fits";
  return (lowest + highest) / 2;
}

/// One frame in which the map moves by `move`; the comb must run through all voxels, be it with
/// what was there, with the newborn, or with those newborn in a slot whose voxel has just changed.
void expect_one_comb(ParticleFilter& filter, bool birth, const VoxelIndex& move, Random& random) {
  filter.particles.predict(0.2, filter.log_odds.index());
  std::vector<std::size_t> counts = filter.counts();
  filter.log_odds.recenter(
      filter.log_odds.index().centre() + move, [&](std::size_t first, std::size_t n) {
        filter.particles.forget(first, n);
        std::fill_n(counts.begin() + static_cast<std::ptrdiff_t>(first), n, 0U);
      });
  draw_log_odds(filter, random);
  const std::vector<double> weights = voxel_weights(filter, counts, birth ? 20 : 0);
  filter.update();
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  EXPECT_EQ(static_cast<double>(filter.particles.total_weight()), sum);

  std::vector<std::size_t> expected(weights.size(), 0);
  const double u = comb_offset(weights, filter.counts());
  const std::size_t n_init = filter.particles.all().size();
  for (const std::size_t slot : reference::systematic_resampling(weights, n_init, u)) {
    ++expected[slot];
  }
  // A tooth so moved may stand on the other side of the border of two voxels, if it was so near.
  const std::vector<std::size_t> found = filter.counts();
  std::size_t different = 0;
  for (std::size_t slot = 0; slot < found.size(); ++slot) {
    different += std::max(found[slot], expected[slot]) - std::min(found[slot], expected[slot]);
  }
  EXPECT_LE(different, 2u);
}

TEST(ParticleResamplingTest, OneCombRunsThroughAllVoxels) {
  Random random(3);
  for (const bool birth : {false, true}) {
    for (const Eigen::Vector3i& n : map_sizes()) {
      if (birth && n.prod() > 2000) continue;  // up to 20 claims a voxel: see kRounding
      SCOPED_TRACE(testing::Message() << n.transpose() << (birth ? ", births" : ""));
      ParticleFilter filter = filter_of(n, 700, birth, 9);
      expect_one_comb(filter, birth, {0, 0, 0}, random);
      expect_one_comb(filter, birth, {1, -2, 0}, random);
      expect_one_comb(filter, birth, {0, 0, 3}, random);
    }
  }
}

TEST(ParticleResamplingTest, CombStartsElsewhereInEachFrame) {
  ParticleFilter filter = filter_of({7, 7, 7}, 2000, false);
  Random random(4);
  std::vector<double> offsets;
  for (int k = 0; k < 8; ++k) {
    draw_log_odds(filter, random);
    filter.particles.predict(0.1, filter.log_odds.index());
    const std::vector<double> weights = voxel_weights(filter, filter.counts(), 0);
    filter.update();
    offsets.push_back(comb_offset(weights, filter.counts()));
  }
  const auto [low, high] = std::minmax_element(offsets.begin(), offsets.end());
  EXPECT_GT(*high - *low, 0.3);
}

TEST(ParticleResamplingTest, AlwaysAllOfThemSortedAndInTheWindow) {
  Random random(5);
  for (const Eigen::Vector3i& n : map_sizes()) {
    for (const std::int64_t count : {1, 7, 63, 64, 65, 128, 129, 4000}) {
      SCOPED_TRACE(testing::Message() << n.transpose() << ", " << count << " particles");
      ParticleFilter filter = filter_of(n, count, true);
      for (int k = 0; k < 4; ++k) {
        filter.particles.predict(0.1, filter.log_odds.index());
        filter.recenter(filter.log_odds.index().centre() + random_vector(-3, 3, random));
        draw_log_odds(filter, random);
        filter.update();
        ASSERT_EQ(filter.particles.all().size(), static_cast<std::size_t>(count));
        expect_in_order(filter, kResolution);
      }
    }
  }
}

// One particle claims half of all, the others next to nothing: their claims are whole units of what
// makes the one's claim fit, and together reach tens of places beyond N_init.
TEST(ParticleResamplingTest, WhatIsClaimedBeyondAllParticlesIsLost) {
  for (const bool birth : {false, true}) {
    ParticleFilter filter = filter_of({64, 64, 64}, 220001, birth);
    filter.frame(0);
    const std::vector<std::size_t> before = filter.counts();
    const auto lonely =
        static_cast<std::size_t>(std::find(before.begin(), before.end(), 1u) - before.begin());
    ASSERT_LT(lonely, before.size());
    std::ranges::fill(filter.log_odds.cells(), -20.0F);
    filter.log_odds.cells()[lonely] = 20;
    filter.frame(0);
    expect_in_order(filter, kResolution);
    const double prior = 1 / 220001.0;
    const double occupied = birth ? 20 + prior : 1 + prior;  // 19 newborn claim 1 each, no prior
    const double all = occupied + 1 + 220000 * std::exp(-20);
    const auto found = static_cast<double>(filter.particles.in_slot(lonely).size());
    EXPECT_NEAR(found, 220001 * occupied / all, 400);  // priors of 76.3 units count as 76
  }
}

TEST(ParticleResamplingTest, OccupiedVoxelsGainWhatFreeOnesLose) {
  ParticleFilter filter = filter_of({8, 8, 8}, 50000, false);
  for (std::size_t slot = 0; slot < 256; ++slot) {  // the half of z < 4 in memory
    filter.log_odds.cells()[slot] = 3.5F;           // P = 0.970688
    filter.log_odds.cells()[slot + 256] = -2;       // P = 0.119203
  }
  filter.frame(0);
  const std::vector<std::size_t> counts = filter.counts();
  const double occupied = std::accumulate(counts.begin(), counts.begin() + 256, 0.0);
  EXPECT_NEAR(occupied / 50000, 0.970688 / (0.970688 + 0.119203), 0.01);
}

}  // namespace
}  // namespace ldm
