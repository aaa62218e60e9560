#include "experiments/cluster_colours.h"

#include <gtest/gtest.h>

#include <set>

namespace experiments {
namespace {

ldm::Cluster cluster(float x, float vx = 0, int voxels = 10) {
  return {.position = {x, 0, 1},
          .size = {0.3F, 0.3F, 1},
          .velocity = {vx, 0, 0},
          .voxels = voxels,
          .dynamic = vx != 0};
}

TEST(ClusterColours, NewClustersTakeDifferentColours) {
  ClusterColours colours(3);
  const auto given = colours.next(0, {cluster(0), cluster(2), cluster(4)});
  EXPECT_EQ(std::set(given.begin(), given.end()).size(), 3u);
}

TEST(ClusterColours, AreKeptWhateverTheOrder) {
  ClusterColours colours(4);
  const auto before = colours.next(0, {cluster(0), cluster(2), cluster(4)});
  const auto after = colours.next(0.1, {cluster(4.05F), cluster(8), cluster(0.05F)});
  EXPECT_EQ(after[0], before[2]);
  EXPECT_EQ(after[2], before[0]);
  EXPECT_EQ(std::set<std::size_t>({before[0], before[1], before[2], after[1]}).size(), 4u);
}

TEST(ClusterColours, FollowTheVelocity) {
  // After 1 s the first is where the second was, and the second is gone from there.
  ClusterColours colours(4);
  const auto before = colours.next(0, {cluster(0, 2), cluster(2, -2)});
  const auto after = colours.next(1, {cluster(2, 2), cluster(0, -2)});
  EXPECT_EQ(after, before);
}

TEST(ClusterColours, OutlastAShortOcclusion) {
  ClusterColours colours(4);
  const auto before = colours.next(0, {cluster(0, 1), cluster(5)});
  colours.next(0.4, {cluster(5)});
  EXPECT_EQ(colours.next(0.8, {cluster(5), cluster(0.8F, 1)})[1], before[0]);
}

TEST(ClusterColours, AreForgottenInTime) {
  ClusterColours colours(2);
  const auto before = colours.next(0, {cluster(0), cluster(5, 0, 30)});
  colours.next(0.9, {cluster(5, 0, 30)});
  // The first was last seen 1.8 s ago: a third cluster may take its colour.
  EXPECT_EQ(colours.next(1.8, {cluster(5, 0, 30), cluster(9)})[1], before[0]);
}

TEST(ClusterColours, ShareTheColourOfTheFewestVoxels) {
  ClusterColours colours(2);
  const auto given = colours.next(0, {cluster(0, 0, 50), cluster(2, 0, 1), cluster(4, 0, 20)});
  EXPECT_NE(given[0], given[1]);
  EXPECT_EQ(given[2], given[1]);
}

}  // namespace
}  // namespace experiments
