/// New particles in occupied voxels that have too few.
#include <gtest/gtest.h>

#include "ldm/particles.h"
#include "tests/ldm/particle_expectations.h"

namespace ldm {
namespace {

constexpr double kResolution = 0.15;

/// A filter in which most voxels hold no particle.
class SparseParticlesTest : public testing::Test {
 protected:
  ParticleFilter filter(bool birth, std::int64_t min_per_voxel, double sigma = 0.5) const {
    ParticleParameters parameters = particle_parameters(20000, sigma);
    parameters.birth = birth;
    parameters.min_per_voxel = min_per_voxel;
    return {map_of({32, 32, 32}), parameters};
  }
  /// A voxel without particles, the `n`-th of them.
  static VoxelIndex empty_voxel(const ParticleFilter& filter, int n = 0) {
    const std::vector<std::size_t> counts = filter.counts();
    const RingIndex& index = filter.log_odds.index();
    for (std::size_t i = 5000; i < counts.size(); ++i) {
      const VoxelIndex v = index.window().voxel(i);
      if (counts[index.slot(v)] == 0 && n-- == 0) return v;
    }
    throw std::logic_error("all voxels hold particles");
  }
};

// In a voxel without particles V_k^j = 0: velocities are N(0, Sigma), positions U(-r/2, r/2).
// Eq. (13)
TEST_F(SparseParticlesTest, NewbornAreEvenInTheVoxelWithNormalVelocities) {
  ParticleFilter f = filter(true, 10000);
  f.particles.predict(0, f.log_odds.index());
  const VoxelIndex v = empty_voxel(f);
  f.log_odds.at(v) = 3.5F;
  f.update();
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> velocities;
  for (const Particle& p : f.particles.in_slot(f.log_odds.index().slot(v))) {
    positions.push_back(f.position(p));
    velocities.push_back(velocity(p));
  }
  // 10000 candidates of weight 0.97 beside 20000 of 0.5: about 9850 of 20000.
  EXPECT_NEAR(static_cast<double>(positions.size()), 9850, 20);
  const Eigen::Vector3d low = v.cast<double>() * kResolution;
  expect_even(positions, low, low.array() + kResolution);
  expect_normal(velocities, {0, 0, 0}, {0.5, 0.5, 0.5});
  // Where one is born says nothing of how it, the one before or the one after moves.
  const std::size_t n = positions.size();
  for (const std::size_t shift : {n - 1, n, n + 1}) {
    double correlation = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Array3d place = (positions[i] - low).array() / kResolution - 0.5;
      correlation += place.matrix().dot(velocities[(i + shift) % n]) / static_cast<double>(n);
    }
    EXPECT_NEAR(correlation, 0, 5 * 0.5 * std::sqrt(3 / 12.0 / static_cast<double>(n)));
  }
}

TEST_F(SparseParticlesTest, NewbornTakeTheMeanVelocityOfTheirVoxel) {
  ParticleFilter f = filter(true, 200, 0);
  f.frame(0);
  // In each voxel one velocity; an occupied voxel of 2 particles gets 198 more.
  const std::vector<std::size_t> counts = f.counts();
  std::vector<Velocity> velocities;
  for (std::size_t slot = 0; slot < counts.size(); ++slot) {
    velocities.emplace_back(slot % 2 == 0 ? 2.0F : -1.0F, static_cast<float>(slot % 3), 0.5F);
    f.particles.set_velocity(slot, 1, CommonVelocity(velocities[slot]));
    if (counts[slot] == 2 && slot % 50 == 0) f.log_odds.cells()[slot] = 3.5F;
  }
  f.frame(0);
  int newborn_voxels = 0;
  for (std::size_t slot = 0; slot < counts.size(); ++slot) {
    if (f.log_odds.cells()[slot] == 0) continue;
    EXPECT_GT(f.particles.in_slot(slot).size(), 20u);
    for (const Particle& p : f.particles.in_slot(slot)) {
      ASSERT_EQ(velocity(p), velocities[slot].cast<double>());
    }
    ++newborn_voxels;
  }
  EXPECT_GT(newborn_voxels, 10);
}

TEST_F(SparseParticlesTest, NoiseIsAddedToTheMeanVelocity) {
  ParticleFilter f = filter(true, 10000);
  f.frame(0);
  const std::vector<std::size_t> counts = f.counts();
  const auto slot =
      static_cast<std::size_t>(std::find(counts.begin() + 9000, counts.end(), 3u) - counts.begin());
  f.particles.set_velocity(slot, 1, CommonVelocity({4, -3, 2}));
  f.log_odds.cells()[slot] = 3.5F;
  f.particles.predict(0, f.log_odds.index());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Particle& p : f.particles.all()) {
    if (p.slot == slot) mean += velocity(p) / 3;
  }
  f.update();
  std::vector<Eigen::Vector3d> velocities;
  for (const Particle& p : f.particles.in_slot(slot)) velocities.push_back(velocity(p));
  EXPECT_GT(velocities.size(), 9000u);
  expect_normal(velocities, mean, {0.5, 0.5, 0.5});
}

/// The slot of a new voxel may still be named by particles of the voxel that left.
TEST_F(SparseParticlesTest, NewVoxelsKnowNothingOfTheParticlesThatLeft) {
  ParticleFilter f = filter(true, 200, 0);
  f.frame(0);
  f.set_all_velocities({2, -1, 0.5});
  f.particles.predict(0, f.log_odds.index());
  const VoxelBox old = f.log_odds.index().window();
  f.recenter({5, 0, 0});
  const VoxelBox& window = f.log_odds.index().window();
  int entered = 0;
  for_each_voxel(window, [&](const VoxelIndex& v, std::size_t) {
    if (old.contains(v) || ++entered % 50 != 0) return;
    f.log_odds.at(v) = 3.5F;
  });
  f.update();
  std::size_t newborn = 0;
  for (const Particle& p : f.particles.all()) {
    const bool is_newborn = !old.contains(voxel_at(f.position(p), kResolution));
    ASSERT_EQ(velocity(p), is_newborn ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(2, -1, 0.5));
    newborn += is_newborn ? 1 : 0;
  }
  EXPECT_GT(newborn, 5000u);
}

TEST_F(SparseParticlesTest, OnlyOccupiedVoxelsWithTooFewAreFilled) {
  ParticleFilter f = filter(true, 3, 0);
  f.particles.predict(0, f.log_odds.index());
  const std::vector<std::size_t> counts = f.counts();
  for (float& l : f.log_odds.cells().first(16384)) l = 1e-4F;  // half of the map, just occupied
  f.particles.weigh(f.log_odds);
  std::uint64_t expected = 0;
  for (std::size_t slot = 0; slot < counts.size(); ++slot) {
    const bool occupied = slot < 16384;
    const std::uint64_t weight = f.particles.updated_weight(f.log_odds.cells()[slot]);
    const std::uint64_t prior = (1 << 24) / 20000;
    expected += counts[slot] * weight;
    if (occupied && counts[slot] < 3) expected += (3 - counts[slot]) * (weight - prior);
  }
  EXPECT_EQ(f.particles.total_weight(), expected);
}

TEST_F(SparseParticlesTest, WithoutBirthEmptyVoxelsStayEmpty) {
  for (const bool birth : {false, true}) {
    ParticleFilter f = filter(birth, 1000);
    f.particles.predict(0, f.log_odds.index());
    const VoxelIndex occupied = empty_voxel(f);
    const VoxelIndex unknown = empty_voxel(f, 1);
    const VoxelIndex free = empty_voxel(f, 2);
    f.log_odds.at(occupied) = 3.5F;
    f.log_odds.at(free) = -2;
    f.update();
    const auto in = [&](const VoxelIndex& v) {
      return f.particles.in_slot(f.log_odds.index().slot(v)).size();
    };
    EXPECT_EQ(in(occupied) > 0, birth);
    EXPECT_EQ(in(unknown), 0u);
    EXPECT_EQ(in(free), 0u);
  }
}

TEST_F(SparseParticlesTest, ThresholdIsThatOfTheClusters) {
  ClusterParameters clusters;
  clusters.occupied_above = 0.7;
  RingBuffer<float> log_odds({32, 32, 32});
  Particles particles(map_of({32, 32, 32}), particle_parameters(1, 0), clusters, {},
                      log_odds.index());
  const auto total = [&](float l) {
    std::fill(log_odds.cells().begin(), log_odds.cells().end(), l);
    particles.predict(0, log_odds.index());
    particles.weigh(log_odds);
    return particles.total_weight();
  };
  EXPECT_LT(total(0.84F), std::uint64_t{2} << 24);       // one particle, no births: P = 0.698
  EXPECT_GT(total(0.85F), std::uint64_t{450000} << 24);  // 20 in each of 32768 voxels: P = 0.701
}

}  // namespace
}  // namespace ldm
