/// Each instruction that has a name against what it means.
#include "ldm/machine/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr int kLowest = INT16_MIN;
constexpr int kHighest = INT16_MAX;

/// Any number, the extremes often.
std::int16_t some_lane(Random& random) {
  constexpr int kExtremes[] = {kLowest, kLowest + 1, -1, 0, 1, kHighest - 1, kHighest};
  const int which = uniform_int(0, 20, random);
  return static_cast<std::int16_t>(which < 7 ? kExtremes[which]
                                             : uniform_int(kLowest, kHighest, random));
}

class LanesTest : public testing::Test {
 protected:
  /// As some_lane, but `b` never the lowest: what the products require.
  void draw() {
    for (int i = 0; i < 8; ++i) {
      a_[i] = some_lane(random_);
      b_[i] = std::max(some_lane(random_), static_cast<std::int16_t>(kLowest + 1));
    }
  }
  template <class Vector>
  static bool same(const Vector& x, const Vector& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
  }

  Random random_{7};
  Int16x8 a_{}, b_{};
};

TEST_F(LanesTest, InstructionsDoWhatTheirPlainFormsSay) {
  for (int trial = 0; trial < 20000; ++trial) {
    draw();
    ASSERT_TRUE(same(saturating_sum(a_, b_), portable::saturating_sum(a_, b_)));
    ASSERT_TRUE(same(rounded_product(a_, b_), portable::rounded_product(a_, b_)));
    ASSERT_TRUE(same(sum_of_products(a_, b_), portable::sum_of_products(a_, b_)));
  }
}

TEST_F(LanesTest, PlainFormsAreRightForKnownNumbers) {
  a_ = Int16x8{kHighest, kLowest, 1, 3, -3, 5, kHighest, kLowest};
  b_ = Int16x8{1, -1, 16384, 16384, 16384, 7, kHighest, kHighest};
  const Int16x8 sum = portable::saturating_sum(a_, b_);
  const Int16x8 expected_sum{kHighest, kLowest, 16385, 16387, 16381, 12, kHighest, -1};
  EXPECT_TRUE(same(sum, expected_sum));
  const Int16x8 product = portable::rounded_product(a_, b_);
  const Int16x8 expected_product{1, 1, 1, 2, -1, 0, 32766, -32767};  // ties up: 0.5, 1.5, -1.5
  EXPECT_TRUE(same(product, expected_product));
  const Int32x4 products = portable::sum_of_products(a_, b_);
  const Int32x4 expected{65535, 65536, -49117, -32767};
  EXPECT_TRUE(same(products, expected));
}

TEST_F(LanesTest, LowerIsWithoutASign) {
  for (int trial = 0; trial < 1000; ++trial) {
    draw();
    const auto x = reinterpret_cast<UInt16x8>(a_);
    const auto y = reinterpret_cast<UInt16x8>(b_);
    const UInt16x8 found = lower(x, y);
    for (int i = 0; i < 8; ++i) ASSERT_EQ(found[i], std::min(x[i], y[i]));
  }
}

TEST(LanesZeroTest, OneBitAnywhereIsNotZero) {
  EXPECT_TRUE(is_zero(UInt8x16{}));
  for (int lane = 0; lane < 16; ++lane) {
    for (int bit = 0; bit < 8; ++bit) {
      UInt8x16 one{};
      one[lane] = static_cast<std::uint8_t>(1 << bit);
      EXPECT_FALSE(is_zero(one)) << lane << " " << bit;
      one[(lane + 8) % 16] = one[lane];
      EXPECT_FALSE(is_zero(one)) << lane << " " << bit << " in both halves";
    }
  }
}

}  // namespace
}  // namespace ldm
