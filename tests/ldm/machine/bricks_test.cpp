#include "ldm/machine/bricks.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

TEST(BricksTest, TheLastMayBeAPartOfOne) {
  EXPECT_EQ(bricks_of(0), 0u);
  EXPECT_EQ(bricks_of(1), 1u);
  EXPECT_EQ(bricks_of(kBrick), 1u);
  EXPECT_EQ(bricks_of(kBrick + 1), 2u);
}

TEST(RangeTest, HoldsWhatItIncludes) {
  Range<float> range;
  EXPECT_FALSE(range.is_one());
  range.include({2, 2});
  EXPECT_TRUE(range.is_one());
  range.include({-1, 1});
  EXPECT_EQ(range.low, -1);
  EXPECT_EQ(range.high, 2);
  range.include({});
  EXPECT_EQ(range.low, -1);
  EXPECT_EQ(range.high, 2);
  EXPECT_FALSE(range.is_one());
}

TEST(SparseNumbersTest, KnowTheBricksThatAreUsed) {
  SparseNumbers numbers(3 * kBrick + 5);
  EXPECT_FALSE(numbers.empty());
  EXPECT_TRUE(SparseNumbers().empty());
  EXPECT_TRUE(numbers.all_zero());
  const auto writer = numbers.writer();
  writer.add_one(kBrick);
  writer.add_one(kBrick);
  writer.set(3 * kBrick + 4, 7);
  EXPECT_EQ(numbers[kBrick], 2u);
  EXPECT_EQ(numbers[3 * kBrick + 4], 7u);
  EXPECT_FALSE(numbers.any_in(0));
  EXPECT_TRUE(numbers.any_in(1));
  EXPECT_FALSE(numbers.any_in(2));
  EXPECT_TRUE(numbers.any_in(3));
  EXPECT_FALSE(numbers.all_zero());
}

// Against plain numbers, over stretches that begin and end within bricks.
TEST(SparseNumbersTest, AreClearedAsPlainNumbersAre) {
  Random random(3);
  const int size = 5 * static_cast<int>(kBrick) + 11;
  SparseNumbers numbers(static_cast<std::size_t>(size));
  std::vector<std::uint32_t> plain(static_cast<std::size_t>(size));
  for (int round = 0; round < 200; ++round) {
    std::vector<std::size_t> written;
    for (int i = uniform_int(0, 40, random); i > 0; --i) {
      written.push_back(static_cast<std::size_t>(uniform_int(0, size - 1, random)));
      numbers.writer().set(written.back(), plain[written.back()] = static_cast<std::uint32_t>(i));
    }
    const int first = uniform_int(0, size - 1, random);
    const int n = uniform_int(0, size - first, random);
    numbers.clear(static_cast<std::size_t>(first), static_cast<std::size_t>(n));
    std::fill_n(plain.begin() + first, n, 0U);
    ASSERT_TRUE(std::equal(plain.begin(), plain.end(), numbers.all().begin()));
    ASSERT_EQ(numbers.all_zero(),
              std::all_of(plain.begin(), plain.end(), [](auto p) { return p == 0; }));
    if (round % 2 == 0) {
      numbers.clear();
      std::fill(plain.begin(), plain.end(), 0U);
      ASSERT_TRUE(numbers.all_zero());
      ASSERT_TRUE(std::equal(plain.begin(), plain.end(), numbers.all().begin()));
    }
  }
}

TEST(SparseNumbersTest, AreClearedByTheListOfThoseThatAreSet) {
  SparseNumbers numbers(4 * kBrick);
  const std::vector<std::size_t> slots = {3, kBrick + 1, kBrick + 1, 4 * kBrick - 1};
  for (const std::size_t slot : slots) numbers.writer().add_one(slot);
  numbers.clear(slots);
  EXPECT_TRUE(numbers.all_zero());
  for (std::size_t brick = 0; brick < 4; ++brick) EXPECT_FALSE(numbers.any_in(brick));
}

}  // namespace
}  // namespace ldm
