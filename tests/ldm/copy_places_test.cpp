/// Where copies go: nowhere, to one place, to two or more, and never beyond the end.
#include "ldm/copy_places.h"

#include <gtest/gtest.h>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr std::uint32_t kEnd = 1000;
constexpr std::uint32_t kSpare = 1234;

TEST(CopyPlacesTest, ByHand) {
  CopyPlaces places;
  places.first[0] = places.last[0] = 7;
  places.first[1] = 7, places.last[1] = 8;
  places.first[2] = 8, places.last[2] = 10;
  EXPECT_FALSE(places.choose(kEnd, kSpare));
  EXPECT_EQ(places.one[0], kSpare);
  EXPECT_EQ(places.other[0], kSpare);
  EXPECT_EQ(places.one[1], 7u);
  EXPECT_EQ(places.other[1], kSpare);
  EXPECT_EQ(places.one[2], 8u);
  EXPECT_EQ(places.other[2], 9u);
  places.first[63] = 10, places.last[63] = 13;
  EXPECT_TRUE(places.choose(kEnd, kSpare));
}

TEST(CopyPlacesTest, WhatIsClaimedBeyondTheEndIsLost) {
  Random random(1);
  const auto place = [&](std::uint32_t lowest, int most) {
    return lowest + static_cast<std::uint32_t>(uniform_int(0, most, random));
  };
  for (int trial = 0; trial < 1000; ++trial) {
    CopyPlaces places;
    CopyPlaces wanted;
    bool third = false;
    for (std::size_t i = 0; i < CopyPlaces::kBlock; ++i) {
      wanted.first[i] = place(kEnd - 30, 60);
      wanted.last[i] = place(wanted.first[i], trial % 2 == 0 ? 2 : 5);
      places.first[i] = wanted.first[i];
      places.last[i] = wanted.last[i];
      third = third || std::min(wanted.last[i], kEnd) > wanted.first[i] + 2;
    }
    ASSERT_EQ(places.choose(kEnd, kSpare), third);
    for (std::size_t i = 0; i < CopyPlaces::kBlock; ++i) {
      const std::uint32_t first = wanted.first[i];
      const std::uint32_t last = std::min(wanted.last[i], kEnd);
      ASSERT_EQ(places.one[i], first < last ? first : kSpare);
      ASSERT_EQ(places.other[i], first + 1 < last ? first + 1 : kSpare);
      ASSERT_LE(places.last[i], kEnd);
    }
  }
}

}  // namespace
}  // namespace ldm
