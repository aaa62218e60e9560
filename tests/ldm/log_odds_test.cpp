#include "ldm/log_odds.h"

#include <gtest/gtest.h>

namespace ldm {
namespace {

// Eq. (1)
TEST(LogOddsTest, ByHand) {
  EXPECT_NEAR(log_odds(0.7), 0.847298, 1e-6);   // ln(7 / 3)
  EXPECT_NEAR(log_odds(0.4), -0.405465, 1e-6);  // ln(2 / 3)
  EXPECT_EQ(log_odds(0.5), 0);
}

// Two hits on an unknown voxel: (7/3)^2 = P / (1 - P), so P = 49/58.  Eq. (7)
TEST(LogOddsTest, MeasurementsMultiplyOdds) {
  EXPECT_NEAR(odds(0.7), 7.0 / 3, 1e-15);
  EXPECT_EQ(odds(0.5), 1);
  EXPECT_NEAR(odds(0.5) * odds(0.7) * odds(0.7), odds(49.0 / 58), 1e-14);
  EXPECT_NEAR(probability(log_odds(0.5) + 2 * log_odds(0.7)), 49.0 / 58, 1e-15);
}

TEST(LogOddsTest, ProbabilityIsTheInverse) {
  EXPECT_EQ(probability(0), 0.5);
  EXPECT_NEAR(probability(-2), 0.119203, 1e-6);  // the clamps of [9]
  EXPECT_NEAR(probability(3.5), 0.970688, 1e-6);
  for (double p = 0.01; p < 1; p += 0.01) EXPECT_NEAR(probability(log_odds(p)), p, 1e-15);
}

}  // namespace
}  // namespace ldm
