/// Where copies go: nowhere, to one place, to two or more, and never beyond the end.
#include "ldm/resampling.h"

#include <gtest/gtest.h>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr std::uint32_t kSize = CopyPlaces::kSize;
constexpr std::uint32_t kPlaces = 1000;
constexpr std::uint32_t kSpare = 1234;

TEST(CopyPlacesTest, ByHand) {
  CopyPlaces places(kPlaces, kSpare);
  places.claim(0, 7 * kSize + 3, 7 * kSize + 9);  // ends in the place in which it begins
  places.claim(1, 7 * kSize + 9, 8 * kSize);
  places.claim(2, 8 * kSize, 10 * kSize + 15);
  EXPECT_FALSE(places.choose());
  EXPECT_EQ(places.first(0), kSpare * kSize);
  EXPECT_EQ(places.second(0), kSpare * kSize);
  EXPECT_EQ(places.first(1), 7 * kSize);
  EXPECT_EQ(places.second(1), kSpare * kSize);
  EXPECT_EQ(places.first(2), 8 * kSize);
  EXPECT_EQ(places.second(2), 9 * kSize);
  places.claim(63, 10 * kSize + 15, 13 * kSize);
  EXPECT_TRUE(places.choose());
  EXPECT_EQ(places.first(63), 10 * kSize);
  EXPECT_EQ(places.second(63), 11 * kSize);
  EXPECT_EQ(places.end(63), 13 * kSize);
}

TEST(CopyPlacesTest, WhatIsClaimedBeyondTheEndIsLost) {
  Random random(1);
  const auto place = [&](std::uint32_t lowest, int most) {
    return lowest + static_cast<std::uint32_t>(uniform_int(0, most, random));
  };
  for (int trial = 0; trial < 1000; ++trial) {
    CopyPlaces places(kPlaces, kSpare);
    std::array<std::uint32_t, CopyPlaces::kBlock> first{};
    std::array<std::uint32_t, CopyPlaces::kBlock> last{};
    bool third = false;
    for (std::size_t i = 0; i < CopyPlaces::kBlock; ++i) {
      first[i] = place(kPlaces - 30, 60);
      last[i] = place(first[i], trial % 2 == 0 ? 2 : 5);
      places.claim(i, first[i] * kSize + place(0, kSize - 1),
                   last[i] * kSize + place(0, kSize - 1));
      first[i] = std::min(first[i], kPlaces);
      last[i] = std::min(last[i], kPlaces);
      third = third || last[i] > first[i] + 2;
    }
    ASSERT_EQ(places.choose(), third);
    for (std::size_t i = 0; i < CopyPlaces::kBlock; ++i) {
      ASSERT_EQ(places.first(i), (first[i] < last[i] ? first[i] : kSpare) * kSize);
      ASSERT_EQ(places.second(i), (first[i] + 1 < last[i] ? first[i] + 1 : kSpare) * kSize);
      ASSERT_EQ(places.end(i), last[i] * kSize);
    }
  }
}

}  // namespace
}  // namespace ldm
