/// The two ways through the particles that predict them: the same bits.
#include "ldm/particle_motion.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

bool has_avx2() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

/// Particles of one map, predicted in any way.
class PredictionPassTest : public testing::TestWithParam<Eigen::Vector3i> {
 protected:
  PredictionPassTest() : index_(GetParam()), noise_(ParticleParameters{}) {
    index_.recenter({123, -45, 6}, [](std::size_t, std::size_t) {});
    // Anywhere in the map, in a slot that nobody may read; a velocity in two is an extreme.
    for (Particle& p : before_) {
      p.x = position_along(0);
      p.y = position_along(1);
      p.z = position_along(2);
      for (std::int16_t* v : {&p.vx, &p.vy, &p.vz}) {
        *v = static_cast<std::int16_t>(uniform_int(INT16_MIN, INT16_MAX, random_));
        if (uniform_int(0, 1, random_) == 0) *v = *v < 0 ? INT16_MIN : INT16_MAX;
      }
      p.slot =
          static_cast<std::uint32_t>(uniform_int(0, static_cast<int>(index_.count()), random_));
    }
  }

  struct Predicted {
    std::vector<Particle> particles;
    std::vector<std::uint32_t> count;

    bool operator==(const Predicted& other) const {
      return count == other.count && std::memcmp(particles.data(), other.particles.data(),
                                                 particles.size() * sizeof(Particle)) == 0;
    }
  };
  /// What `way(pass)` makes of them, where 1 m/s covers so many voxels.
  template <class Way>
  Predicted predicted(double voxels_per_mps, Way way) const {
    Predicted result{before_, {}};
    SparseNumbers count(index_.count() + 1);
    way(PredictionPass{result.particles.data(), count.writer(), noise_,
                       RandomStream(1, Purpose::kPrediction, 2),
                       ParticleMotion(index_, fraction_bits_, voxels_per_mps)});
    count.clear(index_.count(), 1);  // not exact
    result.count.assign(count.all().begin(), count.all().end());
    return result;
  }

 private:
  std::uint16_t position_along(int axis) {
    return static_cast<std::uint16_t>(
        uniform_int(0, (GetParam()[axis] << fraction_bits_) - 1, random_));
  }

  Random random_{5};
  RingIndex index_;
  int fraction_bits_ = ParticleMotion::fraction_bits(GetParam());
  VelocityNoise noise_;
  std::vector<Particle> before_ = std::vector<Particle>(4000);
};

TEST_P(PredictionPassTest, FoursAndPairsAreTheSameBits) {
  for (const double voxels_per_mps : {0., 1e-5, 0.01, 0.6667, 6.7, 300.}) {
    const Predicted pairs =
        predicted(voxels_per_mps, [](const PredictionPass& pass) { pass.move_pairs(2, 3990); });
    const Predicted fours = predicted(voxels_per_mps, [](const PredictionPass& pass) {
      const std::size_t next = pass.move_fours(2, 3989);
      EXPECT_EQ(next, has_avx2() ? 3986u : 2u);
      pass.move_pairs(next, 3989);
    });
    EXPECT_TRUE(fours == pairs) << voxels_per_mps;
  }
}

TEST_P(PredictionPassTest, MovesAnyStretchAsInPairs) {
  for (std::size_t end = 0; end < 12; ++end) {
    const auto in_pairs = [&](const PredictionPass& pass) { pass.move_pairs(0, end); };
    const auto as_a_whole = [&](const PredictionPass& pass) { pass.move(0, end); };
    EXPECT_TRUE(predicted(0.6667, as_a_whole) == predicted(0.6667, in_pairs)) << end;
  }
}

std::vector<Eigen::Vector3i> sizes() {
  std::vector<Eigen::Vector3i> all = map_sizes();
  all.push_back({512, 5, 300});  // few bits of fraction, and large strides
  return all;
}

INSTANTIATE_TEST_SUITE_P(AllSizes, PredictionPassTest, testing::ValuesIn(sizes()));

}  // namespace
}  // namespace ldm
