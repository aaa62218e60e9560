#include "ldm/plain/particles.h"

#include <gtest/gtest.h>

namespace ldm::plain {
namespace {

const VoxelBox kWindow{{-2, -2, -2}, {5, 5, 5}};

Parameters small_parameters() {
  Parameters parameters;
  parameters.map.voxels = kWindow.size;
  parameters.particles.count = 5000;
  parameters.particles.min_per_voxel = 20;
  return parameters;
}

/// All voxels in cluster 0.
const std::vector<int> kOneCluster(kWindow.count(), 0);

TEST(PlainParticles, StartsEvenlyWithZeroMeanVelocity) {
  Particles particles(small_parameters());
  EXPECT_TRUE(particles.empty());
  particles.scatter(kWindow);
  EXPECT_EQ(particles.size(), 5000U);
  const Eigen::Vector3d mean = particles.cluster_velocities(kWindow, kOneCluster, 1)[0];
  EXPECT_LT(mean.norm(), 0.06);  // five standard errors: 0.8 / sqrt(5000) per axis
  particles.remove_outside({kWindow.origin, {5, 5, 2}});
  EXPECT_NEAR(static_cast<double>(particles.size()), 2000, 175);
}

TEST(PlainParticles, ThoseThatLeaveAreRemovedAndResamplingRestoresTheNumber) {
  Particles particles(small_parameters());
  particles.scatter(kWindow);
  particles.predict(0.5);
  particles.remove_outside(kWindow);
  EXPECT_LT(particles.size(), 4000U);
  EXPECT_GT(particles.size(), 100U);
  particles.update(kWindow, std::vector<double>(kWindow.count(), 0));
  particles.resample();
  EXPECT_EQ(particles.size(), 5000U);
}

TEST(PlainParticles, OccupiedVoxelsDrawParticles) {
  Particles particles(small_parameters());
  particles.scatter(kWindow);
  std::vector<double> log_odds(kWindow.count(), -2);  // P = 0.119
  log_odds[0] = 3.5;                                  // P = 0.971
  particles.update(kWindow, log_odds);
  particles.resample();
  VoxelBox corner{kWindow.origin, {1, 1, 1}};
  particles.remove_outside(corner);
  // 0.971 of 0.971 + 124 * 0.119: 308 of 5000.
  EXPECT_NEAR(static_cast<double>(particles.size()), 308, 90);
}

TEST(PlainParticles, BirthFillsAnOccupiedVoxelUp) {
  Parameters parameters = small_parameters();
  parameters.particles.count = 1;
  Particles particles(parameters);
  particles.scatter({{2, 2, 2}, {1, 1, 1}});
  std::vector<double> log_odds(kWindow.count(), -2);
  log_odds[0] = 3.5;
  particles.update(kWindow, log_odds);
  EXPECT_EQ(particles.size(), 21U);
  particles.remove_outside({kWindow.origin, {1, 1, 1}});
  EXPECT_EQ(particles.size(), 20U);
}

TEST(PlainParticles, ReadjustmentGivesAllTheSameVelocity) {
  Particles particles(small_parameters());
  particles.scatter(kWindow);
  particles.readjust(kWindow, kOneCluster, {{1, 2, 3}});
  EXPECT_NEAR(
      (particles.cluster_velocities(kWindow, kOneCluster, 1)[0] - Eigen::Vector3d(1, 2, 3)).norm(),
      0, 1e-9);
}

TEST(PlainParticles, AClusterWithoutParticlesStandsStill) {
  const Particles particles(small_parameters());
  EXPECT_EQ(particles.cluster_velocities(kWindow, kOneCluster, 1)[0], Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace ldm::plain
