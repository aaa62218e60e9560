#include "ldm/machine/random.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <set>

namespace ldm {
namespace {

/// Computed apart from this code, with integers of any length.
TEST(RandomStreamTest, SameBitsOnEveryMachine) {
  EXPECT_EQ(RandomStream(1, Purpose::kPrediction, 1).bits(0), 0x8792dca5ab48775bU);
  EXPECT_EQ(RandomStream(1, Purpose::kPrediction, 1).bits(1), 0x6f6dbea92ac5ea30U);
  EXPECT_EQ(RandomStream(42, Purpose::kResampling, 1000).bits(123456789), 0xe5b526704bb428b2U);
}

TEST(RandomStreamTest, DrawsDifferBySeedPurposeFrameAndNumber) {
  std::set<std::uint64_t> seen;
  std::size_t draws = 0;
  for (const std::uint64_t seed : {0UL, 1UL, 2UL, ~0UL}) {
    for (const Purpose purpose :
         {Purpose::kInitial, Purpose::kPrediction, Purpose::kBirth, Purpose::kResampling}) {
      for (std::uint64_t frame = 0; frame < 20; ++frame) {
        for (std::uint64_t i = 0; i < 20; ++i, ++draws) {
          seen.insert(RandomStream(seed, purpose, frame).bits(i));
        }
      }
    }
  }
  EXPECT_EQ(seen.size(), draws);
}

TEST(RandomStreamTest, EachBitIsSetInHalfOfTheDrawsAndAloneOfTheOneBefore) {
  constexpr int kDraws = 1 << 16;
  const RandomStream stream(7, Purpose::kPrediction, 3);
  for (const int apart : {0, 1, 16, 32, 48}) {  // quarters make draws of noise
    std::array<int, 64> set{};
    std::uint64_t before = 0;
    for (std::uint64_t i = 0; i < kDraws; ++i) {
      const std::uint64_t bits = stream.bits(i);
      const std::uint64_t other = apart == 0 ? before : std::rotl(bits, apart);
      for (std::size_t b = 0; b < 64; ++b) set[b] += static_cast<int>((bits ^ other) >> b & 1);
      before = bits;
    }
    for (const int n : set) EXPECT_NEAR(n, kDraws / 2, 5 * 128);  // five standard deviations
  }
}

}  // namespace
}  // namespace ldm
