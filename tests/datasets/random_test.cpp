/// The simulator's random numbers: moments, independence of order, and fixed bits.
#include "datasets/random.h"

#include <gtest/gtest.h>

namespace datasets {
namespace {

TEST(RandomTest, SplitMixGivesItsPublishedNumbers) {
  // SplitMix64 seeded with 1234567: its state after n steps is seed + n * 0x9e3779b97f4a7c15.
  const std::uint64_t gamma = 0x9e3779b97f4a7c15ULL;
  EXPECT_EQ(mixed(1234567 + gamma), 6457827717110365317ULL);
  EXPECT_EQ(mixed(1234567 + 2 * gamma), 3203168211198807973ULL);
  EXPECT_EQ(mixed(1234567 + 3 * gamma), 9817491932198370423ULL);
}

TEST(RandomTest, UniformFillsItsInterval) {
  Random random(5);
  double sum = 0, least = 9, most = 0;
  for (int i = 0; i < 100000; ++i) {
    const double value = random.uniform(2, 3);
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_NEAR(sum / 100000, 2.5, 5 / std::sqrt(12.0 * 100000));
  EXPECT_GT(least, 2);
  EXPECT_LT(least, 2.001);
  EXPECT_LT(most, 3);
  EXPECT_GT(most, 2.999);
  EXPECT_EQ(random.uniform(Interval{4, 4}), 4);
}

TEST(RandomTest, NormalHasItsMoments) {
  double sum = 0, squares = 0, fourth = 0;
  int beyond_two = 0;
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const double z = normal_of(random_bits(9, static_cast<std::uint64_t>(i)));
    sum += z;
    squares += z * z;
    fourth += z * z * z * z;
    beyond_two += std::abs(z) > 2;
  }
  // Five standard errors each.
  const double root = std::sqrt(kDraws);
  EXPECT_NEAR(sum / kDraws, 0, 5 / root);
  EXPECT_NEAR(squares / kDraws, 1, 5 * std::sqrt(2) / root);
  EXPECT_NEAR(fourth / kDraws, 3, 5 * std::sqrt(96) / root);
  EXPECT_NEAR(beyond_two / static_cast<double>(kDraws), 0.0455, 5 * 0.2085 / root);
}

TEST(RandomTest, StreamsOfDifferentKeysDiffer) {
  Random one(1), again(1), two(2);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t bits = one.bits();
    EXPECT_EQ(bits, again.bits());
    EXPECT_NE(bits, two.bits());
  }
}

}  // namespace
}  // namespace datasets
