/// A particle's three axes side by side: load, noise, motion, store.
#include "ldm/particle_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr int kLowest = INT16_MIN;
constexpr int kHighest = INT16_MAX;

ParticleParameters with_sigma(double sigma) {
  ParticleParameters parameters;
  parameters.sigma_xy = sigma;
  parameters.sigma_z = sigma;
  return parameters;
}

TEST(ParticleLanesTest, StoresWhatItLoadsBesideItsNeighbours) {
  const Particle first{1, 2, 3, 4, 5, 6, 7};
  const Particle last{65535, 0, 65534, -32768, 32767, -1, 0xfffffffe};
  Particle particles[3] = {first, {40000, 50000, 60000, -20000, 20000, -2, 9}, last};
  ParticleLanes lanes(particles[1]);
  EXPECT_EQ(lanes.position[0], 40000);
  EXPECT_EQ(lanes.position[2], 60000);
  EXPECT_EQ(lanes.velocity[0], -20000);
  EXPECT_EQ(lanes.velocity[2], -2);
  lanes.position[1] = 65535;
  lanes.velocity[1] = kLowest;
  lanes.store(0x12345678, particles[1]);
  const Particle& p = particles[1];
  EXPECT_EQ(Eigen::Vector3i(p.x, p.y, p.z), Eigen::Vector3i(40000, 65535, 60000));
  EXPECT_EQ(Eigen::Vector3i(p.vx, p.vy, p.vz), Eigen::Vector3i(-20000, kLowest, -2));
  EXPECT_EQ(p.slot, 0x12345678U);
  EXPECT_EQ(std::memcmp(&particles[0], &first, sizeof first), 0);
  EXPECT_EQ(std::memcmp(&particles[2], &last, sizeof last), 0);
}

TEST(VelocityNoiseTest, SaturatesInsteadOfTurningAround) {
  const VelocityNoise noise(with_sigma(3));
  const std::uint64_t up = ~std::uint64_t{0};
  const Lanes most = noise.changed(all_lanes(kHighest), up);
  const Lanes least = noise.changed(all_lanes(kLowest), 0);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(most[axis], kHighest);
    EXPECT_EQ(least[axis], kLowest);
    EXPECT_GT(noise.changed(Lanes{}, up)[axis], 3 * 3 * 1024);
    EXPECT_LT(noise.changed(Lanes{}, 0)[axis], -3 * 3 * 1024);
  }
}

/// Motion of one map against the same in double precision.
class MotionTest : public testing::TestWithParam<Eigen::Vector3i> {
 protected:
  int fraction_bits() const {
    return 16 - static_cast<int>(std::ceil(std::log2(GetParam().maxCoeff())));
  }
  RingIndex index() const {
    RingIndex index(GetParam());
    index.recenter({123, -45, 6}, [](std::size_t, std::size_t) {});
    return index;
  }
};

// Eq. (5), for steps from a microsecond to minutes and any velocity.
TEST_P(MotionTest, IsRightToTwoQuantaPerMapOrLeaves) {
  const RingIndex ring = index();
  const Eigen::Vector3i n = GetParam();
  const double quanta = std::ldexp(1, fraction_bits());
  Random random(3);
  for (const double voxels_per_mps : {1e-5, 0.01, 0.6667, 6.7, 300., 3000.}) {
    const ParticleMotion motion(ring, fraction_bits(), voxels_per_mps);
    for (int trial = 0; trial < 2000; ++trial) {
      Lanes x{};
      Lanes v{};
      Eigen::Vector3d to;  // in quanta from the window's lowest
      for (int axis = 0; axis < 3; ++axis) {
        const int extent = n[axis] << fraction_bits();
        x[axis] = uniform_int(0, extent - 1, random);
        v[axis] = uniform_int(kLowest, kHighest, random) / (trial % 2 == 0 ? 1 : 2000);
        const int low = ring.origin_slot()[axis] << fraction_bits();
        to[axis] = (x[axis] - low + extent) % extent + v[axis] / 1024. * voxels_per_mps * quanta;
      }
      const Eigen::Array3d size = n.cast<double>().array() * quanta;
      const std::uint32_t slot = motion.move(x, v);
      if (slot == ring.count()) {
        ASSERT_TRUE((to.array() < 3).any() || (to.array() > size - 3).any());
        continue;
      }
      Eigen::Vector3i voxel;
      for (int axis = 0; axis < 3; ++axis) {
        const double at = std::fmod(to[axis] + quanta * ring.origin_slot()[axis], size[axis]);
        const double error = std::abs(x[axis] - at);
        ASSERT_LT(std::min(error, size[axis] - error), 3) << voxels_per_mps;
        voxel[axis] = x[axis] >> fraction_bits();
        ASSERT_LT(voxel[axis], n[axis]);
      }
      ASSERT_EQ(slot,
                static_cast<std::uint32_t>(voxel.x() + n.x() * (voxel.y() + n.y() * voxel.z())));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, MotionTest,
                         testing::Values(Eigen::Vector3i(5, 5, 5), Eigen::Vector3i(32, 32, 32),
                                         Eigen::Vector3i(33, 7, 12),
                                         Eigen::Vector3i(512, 512, 512)));

}  // namespace
}  // namespace ldm
