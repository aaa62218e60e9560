/// Times that are no seconds are told by their size or by their steps.
#include "datasets/recording/scans/time_unit.h"

#include <gtest/gtest.h>

namespace datasets {
namespace {

TEST(TimeUnits, OfAClock) {
  EXPECT_FALSE(unit_other_than_seconds({1.7e9, 1.7e9 + 0.1}));
  EXPECT_EQ(unit_other_than_seconds({1.7e12}), TimeUnit::kMilliseconds);
  EXPECT_EQ(unit_other_than_seconds({1.7e15}), TimeUnit::kMicroseconds);
  EXPECT_EQ(unit_other_than_seconds({1.7e18}), TimeUnit::kNanoseconds);
}

TEST(TimeUnits, OfStepsFromZero) {
  EXPECT_FALSE(unit_other_than_seconds({}));
  EXPECT_FALSE(unit_other_than_seconds({0}));
  EXPECT_FALSE(unit_other_than_seconds({0, 1, 2, 3}));  // which count scans
  EXPECT_EQ(unit_other_than_seconds({0, 100, 200}), TimeUnit::kMilliseconds);
  EXPECT_EQ(unit_other_than_seconds({0, 1e5, 2e5}), TimeUnit::kMicroseconds);
  EXPECT_EQ(unit_other_than_seconds({0, 1e8, 2e8}), TimeUnit::kNanoseconds);
  EXPECT_FALSE(unit_other_than_seconds({0, 0.1, 900, 900.1, 900.2}));  // a pause
}

TEST(TimeUnits, OneOfEach) {
  EXPECT_EQ(seconds_in(TimeUnit::kSeconds), 1);
  EXPECT_EQ(seconds_in(TimeUnit::kNanoseconds), 1e-9);
}

}  // namespace
}  // namespace datasets
