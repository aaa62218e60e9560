/// Prediction of particles, and those that leave the map.
#include <gtest/gtest.h>

#include "ldm/particles.h"
#include "tests/ldm/particle_expectations.h"

namespace ldm {
namespace {

constexpr double kResolution = 0.15;

/// [m] Half a quantum of the position before, half one of rounding, and one of the velocity's step.
double tolerance(const Eigen::Vector3i& voxels) {
  return 2 * kResolution * voxels.maxCoeff() / (1 << 15);
}

/// All in the corner (1, 1, 1) m/s on: particles with velocities known before the noise.
ParticleFilter moving(std::int64_t count, const ParticleParameters& parameters, const Velocity& v) {
  ParticleParameters all = parameters;
  all.count = count;
  ParticleFilter filter(map_of({32, 32, 32}), all);
  filter.frame(0);
  filter.set_all_velocities(v);
  return filter;
}

// Eq. (4)
TEST(ParticlePredictionTest, NoiseIsNormalPerAxisAndIndependent) {
  ParticleParameters parameters = particle_parameters(0, 0.8);
  parameters.sigma_z = 0.16;
  ParticleFilter filter = moving(100000, parameters, {0.5, -1, 0.25});
  filter.particles.predict(0, filter.log_odds.index());
  const std::vector<Eigen::Vector3d> first = filter.velocities();
  expect_normal(first, {0.5, -1, 0.25}, {0.8, 0.8, 0.16});

  filter.particles.predict(0, filter.log_odds.index());
  std::vector<Eigen::Vector3d> second = filter.velocities();
  std::vector<Eigen::Vector3d> to_next;
  for (std::size_t i = 0; i < first.size(); ++i) {
    second[i] -= first[i];
    if (i % 2 == 1) to_next.push_back(second[i] - second[i - 1]);
  }
  expect_normal(second, {0, 0, 0}, {0.8, 0.8, 0.16});
  // Noise of neighbours is independent, so are the noises of two frames: variances add up.
  expect_normal(to_next, {0, 0, 0}, std::sqrt(2) * Eigen::Vector3d(0.8, 0.8, 0.16));
  expect_normal(filter.velocities(), {0.5, -1, 0.25},
                std::sqrt(2) * Eigen::Vector3d(0.8, 0.8, 0.16));
}

// 1.5 m/s times 0.1 s is one voxel of 0.15 m.  Eq. (5)
TEST(ParticlePredictionTest, OneVoxelInOneFrameByHand) {
  ParticleFilter filter = moving(20000, particle_parameters(0, 0), {1.5, 0, -3});
  const std::vector<Particle> before = filter.snapshot();
  filter.particles.predict(0.1, filter.log_odds.index());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Eigen::Vector3d x = filter.position(before[i]);
    const VoxelIndex to = voxel_at(x, kResolution) + VoxelIndex(1, 0, -2);
    const Particle& after = filter.particles.all()[i];
    if (!filter.log_odds.index().window().contains(to)) {
      ASSERT_EQ(after.slot, filter.gone());
      continue;
    }
    ASSERT_EQ(after.slot, filter.log_odds.index().slot(to));
    ASSERT_LT((filter.position(after) - x - Eigen::Vector3d(0.15, 0, -0.3)).norm(), 1e-4);
    ASSERT_EQ(velocity(after), Eigen::Vector3d(1.5, 0, -3));
  }
}

TEST(ParticlePredictionTest, EachMovesByItsVelocityOrLeaves) {
  Random random(1);
  for (const Eigen::Vector3i& n : map_sizes()) {
    SCOPED_TRACE(testing::Message() << n.transpose());
    ParticleFilter filter(map_of(n), particle_parameters(20001, 0.7), 5,
                          random_vector(-60, 60, random));
    const VoxelBox& window = filter.log_odds.index().window();
    const Eigen::Array3d low = window.origin.cast<double>() * kResolution;
    const Eigen::Array3d high = low + window.size.cast<double>().array() * kResolution;
    const double eps = tolerance(n);
    const std::vector<Particle> before = filter.snapshot();
    filter.particles.predict(0.3, filter.log_odds.index());
    int left = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Particle& after = filter.particles.all()[i];
      const Eigen::Vector3d x = filter.position(before[i]) + 0.3 * velocity(after);
      if (after.slot == filter.gone()) {
        ASSERT_TRUE((x.array() < low + eps).any() || (x.array() > high - eps).any());
        ++left;
      } else {
        ASSERT_LT((filter.position(after) - x).cwiseAbs().maxCoeff(), eps);
      }
    }
    EXPECT_GT(left, 100);
    EXPECT_LT(left, 19000);
  }
}

TEST(ParticlePredictionTest, NoTimeNoMotion) {
  ParticleFilter filter = moving(5000, particle_parameters(0, 0.5), {3, 3, 3});
  const std::vector<Eigen::Vector3d> before = filter.positions();
  filter.particles.predict(0, filter.log_odds.index());
  EXPECT_EQ(filter.positions(), before);
}

TEST(ParticlePredictionTest, VelocitiesSaturate) {
  ParticleFilter filter = moving(5000, particle_parameters(0, 3), {31.9F, -31.9F, 0});
  filter.particles.predict(0, filter.log_odds.index());
  for (const Particle& p : filter.particles.all()) {
    ASSERT_GT(p.vx, 0);
    ASSERT_LT(p.vy, 0);
  }
}

TEST(ParticlePredictionTest, ThoseThatLeftAreNotResampled) {
  ParticleParameters parameters = particle_parameters(20000, 0);
  parameters.birth = false;
  ParticleFilter filter(map_of({32, 32, 32}), parameters);
  filter.frame(0);
  // The lower half, y < 0, drifts out of the map; the other stays.
  const VoxelBox& window = filter.log_odds.index().window();
  for (std::size_t i = 0; i < window.count(); ++i) {
    const VoxelIndex v = window.voxel(i);
    const std::size_t slot = filter.log_odds.index().slot(v);
    filter.particles.set_velocity(slot, 1, CommonVelocity({v.y() < 0 ? 30.0F : 0.0F, 0, 0}));
  }
  filter.frame(1);
  expect_in_order(filter, kResolution);
  for (const Eigen::Vector3d& x : filter.positions()) ASSERT_GT(x.y(), 0);
}

TEST(ParticlePredictionTest, ForgottenVoxelsLoseTheirParticles) {
  Random random(2);
  for (const Eigen::Vector3i& n : map_sizes()) {
    SCOPED_TRACE(testing::Message() << n.transpose());
    ParticleParameters parameters = particle_parameters(5000, 0.2);
    parameters.birth = false;
    ParticleFilter filter(map_of(n), parameters, 5);
    for (int k = 0; k < 6; ++k) {
      filter.particles.predict(0.1, filter.log_odds.index());
      const VoxelBox old = filter.log_odds.index().window();
      filter.recenter(filter.log_odds.index().centre() + random_vector(-2, 2, random));
      filter.update();
      expect_in_order(filter, kResolution);
      for (const Eigen::Vector3d& x : filter.positions()) {
        ASSERT_TRUE(old.contains(voxel_at(x, kResolution)));  // nobody stands in new voxels
      }
    }
  }
}

TEST(ParticlePredictionTest, WhenAllAreGoneTheyBeginAnew) {
  const double pauses[] = {1, 1e4, 1e9, 1e300};
  for (const double dt : pauses) {
    SCOPED_TRACE(testing::Message() << "after " << dt << " s");
    ParticleFilter filter = moving(60000, particle_parameters(0, 0), {-30, 25, 9});
    filter.particles.predict(dt, filter.log_odds.index());
    for (const Particle& p : filter.particles.all()) ASSERT_EQ(p.slot, filter.gone());
    filter.update();
    expect_in_order(filter, kResolution);
    expect_even(filter.positions(), Eigen::Vector3d::Constant(-2.4),
                Eigen::Vector3d::Constant(2.4));
    expect_normal(filter.velocities(), {0, 0, 0}, {0, 0, 0});
  }
}

TEST(ParticlePredictionTest, WhenTheMapIsNewTheyBeginAnew) {
  ParticleFilter filter = moving(60000, particle_parameters(0, 0.8), {0, 0, 0});
  filter.particles.predict(0.1, filter.log_odds.index());
  filter.recenter({100, -7, 0});
  filter.update();
  expect_in_order(filter, kResolution);
  const Eigen::Vector3d low = Eigen::Vector3d(100 - 16, -7 - 16, -16) * kResolution;
  expect_even(filter.positions(), low, low.array() + 4.8);
  expect_normal(filter.velocities(), {0, 0, 0}, {0.8, 0.8, 0.8});
}

}  // namespace
}  // namespace ldm
