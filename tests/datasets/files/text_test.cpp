#include "datasets/files/text.h"

#include <gtest/gtest.h>

namespace datasets {
namespace {

TEST(Text, SingleLine) {
  EXPECT_EQ(single_line("no room:\n  for a box\n"), "no room: for a box");
  EXPECT_EQ(single_line(""), "");
}

TEST(Text, DidYouMean) {
  const std::vector<std::string> known = {"sensor.channels", "sensor.range_m", "uav.leg_m", "ldm"};
  EXPECT_EQ(did_you_mean("sensor.chanels", known), "; did you mean sensor.channels?");
  EXPECT_EQ(did_you_mean("sensor.rnage_m", known), "; did you mean sensor.range_m?");
  EXPECT_EQ(did_you_mean("lmd", known), "; did you mean ldm?");
  EXPECT_EQ(did_you_mean("sensor.speed", known), "");  // the right section is no likeness
  EXPECT_EQ(did_you_mean("kalman", known), "");
  EXPECT_EQ(did_you_mean("", known), "");
  EXPECT_EQ(did_you_mean("ldm", {}), "");
}

TEST(Text, Numbers) {
  EXPECT_EQ(decimal(0.1), "0.1");
  EXPECT_EQ(rounded(2.0 / 3, 4), "0.6667");
  EXPECT_EQ(rounded(-1e300, 1).size(), 304U);
  double number = 0;
  EXPECT_TRUE(parse_number("1e3", number));
  EXPECT_EQ(number, 1000);
  for (const char* bad : {"", "1 ", "x", "1,5"}) EXPECT_FALSE(parse_number(bad, number)) << bad;
  EXPECT_EQ(split("a,,b,", ',').size(), 4U);
  EXPECT_EQ(split("", ',').size(), 1U);
}

TEST(Text, TakesWordAfterWord) {
  std::string_view rest = "\t one  two\r";
  EXPECT_EQ(next_word(rest), "one");
  EXPECT_EQ(rest, "  two\r");
  EXPECT_EQ(next_word(rest), "two");
  EXPECT_EQ(next_word(rest), "");
  EXPECT_EQ(rest, "");
}

TEST(Text, CommandLineQuotesWhatAShellWouldBreak) {
  EXPECT_EQ(command_line({"ldm", "run", "--set", "map.voxels=8,8,8"}),
            "ldm run --set map.voxels=8,8,8");
  EXPECT_EQ(command_line({"a b", "", "it's", "$x"}), "'a b' '' 'it'\\''s' '$x'");
}

}  // namespace
}  // namespace datasets
