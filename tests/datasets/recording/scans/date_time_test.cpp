/// Dates with times of day: by hand, and what is none.
#include "datasets/recording/scans/date_time.h"

#include <gtest/gtest.h>

namespace datasets {
namespace {

TEST(DateTime, SecondsSince1970) {
  EXPECT_EQ(seconds_of_date_time("1970-01-01 00:00:00"), 0.0);
  EXPECT_EQ(seconds_of_date_time("1970-01-02 01:02:03.5"), 86400 + 3723.5);
  EXPECT_EQ(seconds_of_date_time("2011-09-26 13:02:25"), 1317042145.0);
  EXPECT_EQ(seconds_of_date_time("2000-03-01T00:00:00Z"), 951868800.0);  // behind a leap day
  EXPECT_NEAR(*seconds_of_date_time("2011-09-26 13:02:25.594360375"), 1317042145.594360375, 3e-7);
}

TEST(DateTime, WhatIsNone) {
  for (const char* text :
       {"", "2011-09-26", "1317042145.5", "2011-09-26 13:02", "2011-09-26 13:02:",
        "2011-13-01 00:00:00", "2011-02-29 00:00:00", "2011-09-26 24:00:00", "2011-09-26 13:60:00",
        "2011-09-26 13:02:61", "2011-09-26 13:02:-1", "2011-09-26 13:02:1e1", "-011-09-26 13:02:25",
        "2011/09/26 13:02:25", "2011-09-26 13:02:25.5 7", "2011-09-26_13:02:25"}) {
    EXPECT_EQ(seconds_of_date_time(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace datasets
