/// Motion of two particles side by side.
#include "ldm/particle_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "ldm/particle.h"
#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr int kLowest = INT16_MIN;
constexpr int kHighest = INT16_MAX;

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
