#include "experiments/metrics/nearest_pairs.h"

#include <gtest/gtest.h>

namespace experiments {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs chosen(std::vector<CandidatePair> candidates) {
  Pairs result;
  for (const CandidatePair& pair : nearest_pairs(std::move(candidates))) {
    result.emplace_back(pair.left, pair.right);
  }
  return result;
}

TEST(NearestPairs, TakeEachSideOnceCheapestFirst) {
  EXPECT_EQ(chosen({{3, 0, 0}, {1, 0, 1}, {2, 1, 1}, {4, 1, 0}, {9, 2, 2}}),
            (Pairs{{0, 1}, {1, 0}, {2, 2}}));
}

TEST(NearestPairs, OfEquallyCheapOnesTakeTheFirst) {
  EXPECT_EQ(chosen({{1, 1, 0}, {1, 0, 0}, {1, 0, 1}}), (Pairs{{1, 0}, {0, 1}}));
  EXPECT_EQ(chosen({}), Pairs{});
}

}  // namespace
}  // namespace experiments
