#include "experiments/study/sweep.h"

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace experiments {
namespace {

std::vector<Point> points(const std::string& text) {
  const tests::TemporaryFolder folder;
  return read_points(datasets::TomlTable::open(folder.write("sweep.toml", text)));
}

std::vector<std::string> descriptions(const std::string& text) {
  std::vector<std::string> all;
  for (const Point& point : points(text)) all.push_back(describe(point));
  return all;
}

using Texts = std::vector<std::string>;

TEST(Sweep, CrossesAxesInFileOrderWithTheLastFastest) {
  EXPECT_EQ(descriptions("[axes]\n\"z.a\" = [1, 2]\n\"b.c\" = [\"x\", true]\n"),
            (Texts{"z.a=1 b.c=x", "z.a=1 b.c=true", "z.a=2 b.c=x", "z.a=2 b.c=true"}));
}

TEST(Sweep, PairsAxes) {
  EXPECT_EQ(
      descriptions("combine = \"paired\"\n[axes]\n\"a.b\" = [0.1, 0.15]\n\"a.c\" = [48, 32]\n"),
      (Texts{"a.b=0.1 a.c=48", "a.b=0.15 a.c=32"}));
}

TEST(Sweep, RangesBetweenWholeNumbersAreWhole) {
  EXPECT_EQ(descriptions("[axes]\n\"a.b\" = {from = 1, to = 10, steps = 4}\n"),
            (Texts{"a.b=1", "a.b=4", "a.b=7", "a.b=10"}));
  EXPECT_EQ(descriptions("[axes]\n\"a.b\" = {from = 10, to = 1000, steps = 3, scale = \"log\"}\n"),
            (Texts{"a.b=10", "a.b=100", "a.b=1000"}));
}

TEST(Sweep, OtherRangesAreReadable) {
  EXPECT_EQ(descriptions("[axes]\n\"a.b\" = {from = 0.0, to = 0.3, steps = 4}\n"),
            (Texts{"a.b=0", "a.b=0.1", "a.b=0.2", "a.b=0.3"}));
}

TEST(Sweep, AListOfListsIsAnAxisOfVectors) {
  EXPECT_EQ(descriptions("[axes]\n\"map.voxels\" = [[64, 64, 32], 16]\n"),
            (Texts{"map.voxels=64,64,32", "map.voxels=16"}));
}

TEST(Sweep, SaysWhereItIsWrong) {
  const auto error = [](const std::string& text) {
    return tests::message_of([&] { points(text); });
  };
  EXPECT_NE(error("combine = \"cross\"\n").find("sweep.toml:1: axes is missing"),
            std::string::npos);
  EXPECT_NE(error("[axes]\n").find("sweep.toml:1: sweep.axes: allowed: at least one axis"),
            std::string::npos);
  EXPECT_NE(error("combine = \"both\"\n[axes]\n\"a.b\" = [1]\n").find("sweep.toml:1: combine"),
            std::string::npos);
  EXPECT_NE(error("[axes]\n\"a.b\" = []\n").find("sweep.toml:2: axes.a.b = []"), std::string::npos);
  EXPECT_NE(
      error("[axes]\n\"a.b\" = [1, 2, 1]\n").find("sweep.toml:2: a.b: the value 1 comes twice"),
      std::string::npos);
  EXPECT_NE(error("[axes]\na.b = [1, 2]\n").find("sweep.toml:2: a: allowed: a full name in quotes"),
            std::string::npos);
  EXPECT_NE(error("combine = \"paired\"\n[axes]\n\"a.b\" = [1, 2]\n\"a.c\" = [1]\n")
                .find("sweep.toml:4: a.c has 1 values: allowed: 2"),
            std::string::npos);
  EXPECT_NE(error("[axes]\n\"a.b\" = {from = 0, to = 1, steps = 3, scale = \"log\"}\n")
                .find("sweep.toml:2: axes.a.b.from = 0"),
            std::string::npos);
  EXPECT_NE(error("[axes]\n\"a.b\" = {from = 0, to = 1, steps = 1}\n").find(".steps = 1"),
            std::string::npos);
}

}  // namespace
}  // namespace experiments
