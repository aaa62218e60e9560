#include "ldm/cluster_velocity.h"

#include <gtest/gtest.h>

#include "tests/ldm/particle_filter.h"

namespace ldm {
namespace {

/// Two clusters: A of the voxels (0, 0, 0) and (1, 0, 0), B of the voxel (-3, 0, 0).
class ClusterVelocityTest : public testing::Test {
 protected:
  ClusterVelocityTest() {
    for (const VoxelIndex& v : {VoxelIndex(0, 0, 0), VoxelIndex(1, 0, 0), VoxelIndex(-3, 0, 0)}) {
      filter_.log_odds.at(v) = 3.5F;
    }
    filter_.frame(0);
    clustering_.find(filter_.log_odds);
    EXPECT_EQ(clustering_.clusters().size(), 2u);
  }

  const RingIndex& index() const { return filter_.log_odds.index(); }
  void give(const VoxelIndex& v, const Velocity& velocity) {
    filter_.particles.set_velocity(index().slot(v), 1, CommonVelocity(velocity));
  }
  std::size_t particles_in(const VoxelIndex& v) const {
    return filter_.particles.in_slot(index().slot(v)).size();
  }
  /// The cluster at world x.
  const Cluster& cluster_at(float x) const {
    for (const Cluster& c : clustering_.clusters()) {
      if (std::abs(c.position.x() - x) < 0.1F) return c;
    }
    throw std::logic_error("no cluster there");
  }
  const Cluster& a() const { return cluster_at(0.15F); }
  const Cluster& b() const { return cluster_at(-0.375F); }
  void set_velocities() {
    set_cluster_velocities(parameters_, index(), filter_.particles, clustering_);
  }

  ParticleFilter filter_{map_of({7, 7, 7}), particle_parameters(3000, 0.8)};
  Clustering clustering_{map_of({7, 7, 7}), {}};
  ClusterParameters parameters_;
};

// n particles of one voxel at 1 m/s, m of the other at (0, -2, 0.5) m/s.  Eq. (16)
TEST_F(ClusterVelocityTest, MeanOverTheParticlesOfItsVoxels) {
  give({0, 0, 0}, {1, 0, 0});
  give({1, 0, 0}, {0, -2, 0.5});
  give({-3, 0, 0}, {-4, 0, 0});
  const auto n = static_cast<float>(particles_in({0, 0, 0}));
  const auto m = static_cast<float>(particles_in({1, 0, 0}));
  ASSERT_GT(n, 0);
  ASSERT_GT(m, 0);
  set_velocities();
  EXPECT_TRUE(a().velocity.isApprox(Velocity(n, -2 * m, 0.5F * m) / (n + m), 1e-5F));
  EXPECT_EQ(b().velocity, Velocity(-4, 0, 0));
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_TRUE(cluster_velocity(clustering_.runs_of(c), index(), filter_.particles)
                    .isApprox(clustering_.clusters()[c].velocity, 1e-3F));
  }
}

// Eq. (17)
TEST_F(ClusterVelocityTest, ParticlesTakeTheVelocityOfTheirCluster) {
  const std::vector<Particle> before = filter_.snapshot();
  set_velocities();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Particle& p = filter_.particles.all()[i];
    EXPECT_EQ(filter_.position(p), filter_.position(before[i]));
    Eigen::Vector3d expected = velocity(before[i]);
    for (const VoxelIndex& v : {VoxelIndex(0, 0, 0), VoxelIndex(1, 0, 0)}) {
      if (p.slot == index().slot(v)) expected = a().velocity.cast<double>();
    }
    if (p.slot == index().slot({-3, 0, 0})) expected = b().velocity.cast<double>();
    ASSERT_LT((velocity(p) - expected).cwiseAbs().maxCoeff(), 0.51 / 1024);
  }
}

TEST_F(ClusterVelocityTest, WithoutReadjustmentParticlesKeepTheirs) {
  parameters_.readjust = false;
  const std::vector<Eigen::Vector3d> before = filter_.velocities();
  set_velocities();
  EXPECT_EQ(filter_.velocities(), before);
  EXPECT_GT(a().velocity.norm(), 0);
}

TEST_F(ClusterVelocityTest, DynamicFromTheThresholdVelocityOn) {
  parameters_.static_below = 0.25;
  give({-3, 0, 0}, {0, 0, -0.25});
  give({0, 0, 0}, {0.15F, -0.15F, 0.1F});
  give({1, 0, 0}, {0.15F, -0.15F, 0.1F});  // 0.235 m/s
  set_velocities();
  EXPECT_TRUE(b().dynamic);
  EXPECT_FALSE(a().dynamic);
  parameters_.static_below = 0.2;
  set_velocities();
  EXPECT_TRUE(a().dynamic);
}

TEST_F(ClusterVelocityTest, NoParticlesNoVelocity) {
  ParticleParameters one = particle_parameters(1, 0.8);
  one.birth = false;
  ParticleFilter lonely(map_of({7, 7, 7}), one);
  lonely.frame(0);
  for (const VoxelIndex& v : {VoxelIndex(0, 0, 0), VoxelIndex(-3, 0, 0)}) {
    ASSERT_TRUE(lonely.particles.in_slot(index().slot(v)).empty());
  }
  set_velocities();
  EXPECT_NE(b().velocity, Velocity(0, 0, 0));
  set_cluster_velocities(parameters_, index(), lonely.particles, clustering_);
  EXPECT_EQ(b().velocity, Velocity(0, 0, 0));
  EXPECT_FALSE(b().dynamic);
}

}  // namespace
}  // namespace ldm
