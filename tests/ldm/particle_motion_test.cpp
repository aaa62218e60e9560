/// Two particles' axes side by side: load, motion, store.
#include "ldm/particle_motion.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr int kLowest = INT16_MIN;
constexpr int kHighest = INT16_MAX;

TEST(ParticlePairTest, StoresWhatItLoadsBesideItsNeighbours) {
  const Particle first{1, 2, 3, 4, 5, 6, 7};
  const Particle last{65535, 0, 65534, -32768, 32767, -1, 0xfffffffe};
  Particle particles[4] = {
      first, {10000, 20000, 30000, -20000, 20000, -2, 9}, {4, 5, 6, -7, 8, kLowest, 10}, last};
  ParticlePair pair(&particles[1]);
  for (const auto& [lane, x, v] :
       {std::array{0, 10000, -20000}, std::array{1, 20000, 20000}, std::array{2, 30000, -2},
        std::array{4, 4, -7}, std::array{5, 5, 8}, std::array{6, 6, kLowest}}) {
    EXPECT_EQ(pair.position[lane], x);
    EXPECT_EQ(pair.velocity[lane], v);
  }
  pair.position[1] = kHighest;
  pair.velocity[5] = kLowest;
  pair.store(Int32x4{0x12345678, 1, 0x0abcdef0, 2}, &particles[1]);
  const Particle& p = particles[1];
  EXPECT_EQ(Eigen::Vector3i(p.x, p.y, p.z), Eigen::Vector3i(10000, kHighest, 30000));
  EXPECT_EQ(Eigen::Vector3i(p.vx, p.vy, p.vz), Eigen::Vector3i(-20000, 20000, -2));
  EXPECT_EQ(p.slot, 0x12345678U);
  const Particle& q = particles[2];
  EXPECT_EQ(Eigen::Vector3i(q.x, q.y, q.z), Eigen::Vector3i(4, 5, 6));
  EXPECT_EQ(Eigen::Vector3i(q.vx, q.vy, q.vz), Eigen::Vector3i(-7, kLowest, kLowest));
  EXPECT_EQ(q.slot, 0x0abcdef0U);
  EXPECT_EQ(std::memcmp(&particles[0], &first, sizeof first), 0);
  EXPECT_EQ(std::memcmp(&particles[3], &last, sizeof last), 0);
}

TEST(VelocitySumTest, OfManyIsThatOfEach) {
  Random random(5);
  for (const std::size_t n : {0, 1, 2, 7, 200001}) {
    std::vector<Particle> some(n);
    VelocitySum each;
    for (Particle& p : some) {
      p.vx = static_cast<std::int16_t>(uniform_int(kLowest, kHighest, random));
      p.vy = kLowest;
      p.vz = kHighest;
      each.add(p);
    }
    VelocitySum many;
    many.add(some);
    EXPECT_EQ(many.x, each.x);
    EXPECT_EQ(many.y, std::int64_t{kLowest} * static_cast<std::int64_t>(n));
    EXPECT_EQ(many.z, std::int64_t{kHighest} * static_cast<std::int64_t>(n));
    EXPECT_EQ(many.particles, static_cast<std::int64_t>(n));
  }
}

TEST(CommonVelocityTest, ChangesTheVelocityAlone) {
  Particle particles[] = {{1, 2, 65535, 4, 5, 6, 0xfffffffe},
                          {7, 8, 9, -1, kLowest, kHighest, 1},
                          {4, 5, 6, 7, 8, 9, 3}};
  CommonVelocity({-0.5F, 40, 2.0F / 1024}).give({particles, 2});
  for (int i = 0; i < 2; ++i) {
    const Particle& p = particles[i];
    EXPECT_EQ(Eigen::Vector3i(p.vx, p.vy, p.vz), Eigen::Vector3i(-512, kHighest, 2));
  }
  EXPECT_EQ(Eigen::Vector3i(particles[0].x, particles[0].y, particles[0].z),
            Eigen::Vector3i(1, 2, 65535));
  EXPECT_EQ(particles[0].slot, 0xfffffffe);
  EXPECT_EQ(Eigen::Vector3i(particles[1].x, particles[1].y, particles[1].z),
            Eigen::Vector3i(7, 8, 9));
  EXPECT_EQ(particles[1].slot, 1u);
  EXPECT_EQ(Eigen::Vector3i(particles[2].vx, particles[2].vy, particles[2].vz),
            Eigen::Vector3i(7, 8, 9));
}

/// Motion of one map against the same in double precision.
class MotionTest : public testing::TestWithParam<Eigen::Vector3i> {
 protected:
  int fraction_bits() const { return ParticleMotion::fraction_bits(GetParam()); }
  RingIndex index() const {
    RingIndex index(GetParam());
    index.recenter({123, -45, 6}, [](std::size_t, std::size_t) {});
    return index;
  }
};

TEST_P(MotionTest, PositionsHaveTheMostFractionBitsThatFitFifteen) {
  const int largest = GetParam().maxCoeff();
  EXPECT_LE(largest << fraction_bits(), 1 << 15);
  EXPECT_GT(largest << (fraction_bits() + 1), 1 << 15);
}

// Eq. (5), for steps from a microsecond to minutes and any velocity.
TEST_P(MotionTest, ErrsByAQuantumOfPositionOrTwoOfVelocityOrLeaves) {
  const RingIndex ring = index();
  const Eigen::Vector3i n = GetParam();
  const double quanta = std::ldexp(1, fraction_bits());
  Random random(3);
  for (const double voxels_per_mps : {1e-5, 0.01, 0.6667, 6.7, 300., 3000.}) {
    const ParticleMotion motion(ring, fraction_bits(), voxels_per_mps);
    const double tolerance =
        std::max(1., 2 * voxels_per_mps * quanta * Particle::kVelocityQuantum) + 1e-6;
    int stayed = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      UInt16x8 x{};
      Int16x8 v{};
      Eigen::Vector3d to[2];  // in quanta from the window's lowest
      for (int lane = 0; lane < 8; ++lane) {
        v[lane] = static_cast<std::int16_t>(uniform_int(kLowest, kHighest, random) /
                                            (trial % 2 == 0 ? 1 : 2000));
        x[lane] = static_cast<std::uint16_t>(v[lane]);  // means nothing in lanes 3 and 7
        const int axis = lane % 4;
        if (axis == 3) continue;
        const int extent = n[axis] << fraction_bits();
        x[lane] = static_cast<std::uint16_t>(uniform_int(0, extent - 1, random));
        const int low = ring.origin_slot()[axis] << fraction_bits();
        to[lane / 4][axis] =
            (x[lane] - low + extent) % extent + v[lane] / 1024. * voxels_per_mps * quanta;
      }
      const Eigen::Array3d size = n.cast<double>().array() * quanta;
      const Int32x4 slots = motion.move(x, v);
      for (int i = 0; i < 2; ++i) {
        const auto slot = static_cast<std::size_t>(slots[2 * i]);
        if (slot == ring.count()) {
          ASSERT_TRUE((to[i].array() < tolerance).any() ||
                      (to[i].array() > size - tolerance).any());
          continue;
        }
        ASSERT_TRUE((to[i].array() > -tolerance).all() && (to[i].array() < size + tolerance).all());
        ++stayed;
        Eigen::Vector3i voxel;
        for (int axis = 0; axis < 3; ++axis) {
          const double at = std::fmod(to[i][axis] + quanta * ring.origin_slot()[axis], size[axis]);
          const double error = std::abs(x[4 * i + axis] - at);
          ASSERT_LT(std::min(error, size[axis] - error), tolerance) << voxels_per_mps;
          voxel[axis] = x[4 * i + axis] >> fraction_bits();
          ASSERT_LT(voxel[axis], n[axis]);
        }
        ASSERT_EQ(slot,
                  static_cast<std::size_t>(voxel.x() + n.x() * (voxel.y() + n.y() * voxel.z())));
      }
    }
    // The longest step takes a velocity quantum across 3 voxels: none stays in the smallest map.
    if (voxels_per_mps < 3000) {
      EXPECT_GT(stayed, 0);
    }
  }
}

// From the lowest position of the map, the one that no 15 bits reach beyond.
TEST_P(MotionTest, TheFastestLeaveAfterAPause) {
  const RingIndex ring = index();
  const ParticleMotion motion(ring, fraction_bits(), 100);
  for (const int speed : {kLowest, kHighest}) {
    UInt16x8 x{};
    Int16x8 v{};
    for (int lane = 0; lane < 8; ++lane) {
      if (lane % 4 == 3) continue;
      x[lane] = static_cast<std::uint16_t>(ring.origin_slot()[lane % 4] << fraction_bits());
      v[lane] = static_cast<std::int16_t>(speed);
    }
    const Int32x4 slots = motion.move(x, v);
    EXPECT_EQ(static_cast<std::size_t>(slots[0]), ring.count());
    EXPECT_EQ(static_cast<std::size_t>(slots[2]), ring.count());
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, MotionTest,
                         testing::Values(Eigen::Vector3i(5, 5, 5), Eigen::Vector3i(32, 32, 32),
                                         Eigen::Vector3i(33, 7, 12),
                                         Eigen::Vector3i(512, 512, 512)));

}  // namespace
}  // namespace ldm
