/// Particles and their state: positions, velocities, how they begin.
#include "ldm/particles.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/ldm/particle_expectations.h"

namespace ldm {
namespace {

/// The smallest voxel of a window and the end of its largest [m].
Eigen::Vector3d low_of(const ParticleFilter& filter, double resolution) {
  return filter.log_odds.index().window().origin.cast<double>() * resolution;
}
Eigen::Vector3d high_of(const ParticleFilter& filter, double resolution) {
  const VoxelBox& window = filter.log_odds.index().window();
  return (window.origin + window.size).cast<double>() * resolution;
}

// With 32 voxels per axis a voxel has 2^10 steps, and the window begins at voxel -16.  Eq. (2)
TEST(ParticlesTest, PositionByHand) {
  const ParticleFilter filter(map_of({32, 32, 32}), particle_parameters(1, 0));
  Particle p{};
  p.x = 5 * 1024 + 256;   // voxel 5, a quarter of it
  p.y = 20 * 1024 + 512;  // voxel 20 - 32, half of it
  p.z = 0;
  const Eigen::Vector3d x = filter.position(p);
  const double half_a_step = 0.15 / 2048;
  EXPECT_NEAR(x.x(), 5.25 * 0.15 + half_a_step, 1e-12);
  EXPECT_NEAR(x.y(), -11.5 * 0.15 + half_a_step, 1e-12);
  EXPECT_NEAR(x.z(), half_a_step, 1e-12);
}

// Eq. (3)
TEST(ParticlesTest, VelocityInItsQuanta) {
  ParticleFilter filter(map_of({5, 5, 5}), particle_parameters(500, 0));
  filter.frame(0);
  filter.set_all_velocities({0.5F, -1.25F, 100});
  for (const Particle& p : filter.particles.all()) {
    ASSERT_EQ(p.vx, 512);
    ASSERT_EQ(p.vy, -1280);
    ASSERT_EQ(p.vz, 32767);  // as fast as can be said
  }
  filter.set_all_velocities({-100, 0.0006F, -0.0004F});
  for (const Particle& p : filter.particles.all()) {
    ASSERT_EQ(p.vx, -32768);
    ASSERT_EQ(p.vy, 1);
    ASSERT_EQ(p.vz, 0);
  }
}

TEST(ParticlesTest, BeginEvenlyOverTheWindowWithNormalVelocities) {
  ParticleParameters parameters = particle_parameters(60000, 0.8);
  parameters.sigma_z = 0.16;
  for (const Eigen::Vector3i& n : map_sizes()) {
    SCOPED_TRACE(testing::Message() << n.transpose());
    const ParticleFilter filter(map_of(n), parameters, 3, {17, -40, 2});
    ASSERT_EQ(filter.particles.all().size(), 60000u);
    expect_even(filter.positions(), low_of(filter, 0.15), high_of(filter, 0.15));
    expect_normal(filter.velocities(), {0, 0, 0}, {0.8, 0.8, 0.16});
    for (const Particle& p : filter.particles.all()) {
      ASSERT_EQ(p.slot, filter.log_odds.index().slot(voxel_at(filter.position(p), 0.15)));
    }
  }
}

TEST(ParticlesTest, LongestMapFitsTheirPositions) {
  const Eigen::Vector3i n(512, 5, 5);
  ParticleFilter filter(map_of(n), particle_parameters(20000, 0.5), 3, {1000, 0, 0});
  expect_even(filter.positions(), low_of(filter, 0.15), high_of(filter, 0.15));
  filter.frame(0.1);
  expect_in_order(filter, 0.15);
}

TEST(ParticlesTest, SameSeedSameBitsAnotherSeedOthers) {
  const auto run = [](std::uint64_t seed) {
    ParticleFilter filter(map_of({7, 7, 7}), particle_parameters(3000, 0.8), seed);
    for (float& l : filter.log_odds.cells().first(100)) l = 2;
    for (int k = 0; k < 4; ++k) filter.frame(0.1);
    return filter.snapshot();
  };
  const auto bytes = [](const std::vector<Particle>& p) {
    return std::string(reinterpret_cast<const char*>(p.data()), p.size() * sizeof(Particle));
  };
  EXPECT_EQ(bytes(run(1)), bytes(run(1)));
  EXPECT_NE(bytes(run(1)), bytes(run(2)));
}

Particle with_velocity(std::int16_t x, std::int16_t y, std::int16_t z) {
  Particle p{};
  p.vx = x;
  p.vy = y;
  p.vz = z;
  return p;
}

// Weights are equal after resampling, so the weighted average is the mean.  Eq. (12)
TEST(VoxelVelocityTest, MeanOfThreeByHand) {
  VelocitySum sum;
  EXPECT_EQ(sum.mean(), Velocity(0, 0, 0));
  sum.add(with_velocity(512, -1024, 32767));
  sum.add(with_velocity(1024, -1024, 32767));
  VelocitySum third;
  third.add(with_velocity(1536, 512, 32767));
  sum.add(third);
  EXPECT_EQ(sum.particles, 3);
  EXPECT_EQ(sum.mean(), Velocity(1, -0.5, 32767.0F / 1024));
}

TEST(VoxelVelocityTest, MeanOfTheParticlesOfEachVoxel) {
  ParticleFilter filter(map_of({7, 7, 7}), particle_parameters(2000, 1.5));
  for (std::size_t slot = 0; slot < 343; slot += 3) filter.log_odds.cells()[slot] = 3.5F;
  for (int k = 0; k < 3; ++k) filter.frame(0.2);
  std::vector<Eigen::Vector3d> sums(343, Eigen::Vector3d::Zero());
  for (const Particle& p : filter.particles.all()) sums[p.slot] += velocity(p);
  const std::vector<std::size_t> counts = filter.counts();
  for (std::size_t slot = 0; slot < 343; ++slot) {
    const Eigen::Vector3d mean = sums[slot] / std::max(1.0, static_cast<double>(counts[slot]));
    EXPECT_EQ(filter.particles.in_slot(slot).size(), counts[slot]);
    EXPECT_LT((filter.particles.voxel_velocity(slot).cast<double>() - mean).norm(), 1e-5);
  }
}

// Threads share out pairs: some have none, and the last pair may lack its second.
TEST(ParticlesTest, FewOfThemAreTheSameForAnyNumberOfThreads) {
  for (std::int64_t count = 1; count < 10; ++count) {
    std::vector<Particle> alone;
    for (const std::int64_t threads : {1, 2, 3, 8}) {
      RingBuffer<float> log_odds({7, 7, 7});
      for (std::size_t slot = 0; slot < 343; slot += 3) log_odds.cells()[slot] = 3.5F;
      Particles particles(map_of({7, 7, 7}), particle_parameters(count, 0.8), {},
                          {.threads = threads, .seed = 1}, log_odds.index());
      for (int k = 0; k < 5; ++k) {
        particles.predict(0.2, log_odds.index());
        particles.weigh(log_odds);
        particles.resample(log_odds.index());
      }
      if (threads == 1) alone.assign(particles.all().begin(), particles.all().end());
      ASSERT_EQ(particles.all().size(), alone.size());
      ASSERT_EQ(std::memcmp(particles.all().data(), alone.data(), alone.size() * sizeof(Particle)),
                0);
    }
  }
}

TEST(ParticlesTest, StretchesOfSlotsHoldTheParticlesOfEach) {
  ParticleParameters parameters = particle_parameters(200, 1.5);
  parameters.birth = false;  // some slots are empty
  ParticleFilter filter(map_of({7, 7, 7}), parameters);
  filter.frame(0.2);
  for (std::size_t first = 0; first <= 343; ++first) {
    std::size_t particles = 0;
    for (std::size_t n = 0; first + n <= 343; ++n) {
      if (n > 0) particles += filter.particles.in_slot(first + n - 1).size();
      const std::span<const Particle> some = filter.particles.in_slots(first, n);
      ASSERT_EQ(some.size(), particles);
      for (const Particle& p : some) ASSERT_TRUE(p.slot >= first && p.slot < first + n);
    }
  }
}

}  // namespace
}  // namespace ldm
