#include "tests/reference/resampling_oracle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace reference {
namespace {

using Picked = std::vector<std::size_t>;

TEST(ResamplingOracle, TeethPickInProportionToWeight) {
  EXPECT_EQ(systematic_resampling({1, 0, 3}, 4, 0.5), (Picked{0, 2, 2, 2}));
  EXPECT_EQ(systematic_resampling({1, 1, 1, 1}, 2, 0.25), (Picked{0, 2}));
  EXPECT_EQ(systematic_resampling({2}, 3, 0.9), (Picked{0, 0, 0}));
}

TEST(ResamplingOracle, AToothOnABoundaryPicksTheNextWithWeight) {
  EXPECT_EQ(systematic_resampling({1, 0, 1}, 2, 0), (Picked{0, 2}));
}

TEST(ResamplingOracle, NothingWithoutWeightIsPicked) {
  // 0.1 + 0.2 + 0.3 rounds upwards: the last tooth comes close to the end of the comb.
  const double almost_one = std::nextafter(1.0, 0.0);
  for (const std::size_t picked : systematic_resampling({0, 0.1, 0.2, 0.3, 0, 0}, 7, almost_one)) {
    EXPECT_GE(picked, 1U);
    EXPECT_LE(picked, 3U);
  }
}

}  // namespace
}  // namespace reference
