#include "experiments/study/seeds.h"

#include <gtest/gtest.h>

#include <set>

namespace experiments {
namespace {

TEST(Seeds, DifferInEveryArgument) {
  std::set<std::uint64_t> seeds;
  for (const char* study : {"table1", "particles"}) {
    for (const char* point : {"", "particles.count=10"}) {
      for (const std::int64_t replicate : {1, 2}) {
        for (const char* method : {"ldm", "octomap"}) {
          seeds.insert(filter_seed(study, point, replicate, method));
        }
      }
    }
  }
  seeds.insert(scenario_seed("scenario1", 1));
  seeds.insert(scenario_seed("scenario1", 2));
  seeds.insert(scenario_seed("scenario2", 1));
  EXPECT_EQ(seeds.size(), 19u);
}

/// Published records name these seeds: they may never change.
TEST(Seeds, AreTheSameForEver) {
  EXPECT_EQ(scenario_seed("scenario1", 1), 14663681363185986641u);
  EXPECT_EQ(filter_seed("table1", "", 1, "ldm"), 357408509119857399u);
}

}  // namespace
}  // namespace experiments
