/// Particles two by two, many at once, and their sums.
#include "ldm/particle.h"

#include <gtest/gtest.h>

#include <array>
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

}  // namespace
}  // namespace ldm
