#include "datasets/files/text.h"

#include <gtest/gtest.h>

namespace datasets {
namespace {

TEST(Text, SingleLine) {
  EXPECT_EQ(single_line("no room:\n  for a box\n"), "no room: for a box");
  EXPECT_EQ(single_line(""), "");
}

TEST(Text, CommandLineQuotesWhatAShellWouldBreak) {
  EXPECT_EQ(command_line({"ldm", "run", "--set", "map.voxels=8,8,8"}),
            "ldm run --set map.voxels=8,8,8");
  EXPECT_EQ(command_line({"a b", "", "it's", "$x"}), "'a b' '' 'it'\\''s' '$x'");
}

}  // namespace
}  // namespace datasets
