#include "experiments/pictures/cluster_colours.h"

#include <gtest/gtest.h>

#include <set>

namespace experiments {
namespace {

ldm::Cluster cluster(int voxels = 10) {
  ldm::Cluster cluster;
  cluster.voxels = voxels;
  return cluster;
}

TEST(ClusterColours, NewTracksTakeDifferentColours) {
  ClusterColours colours(3);
  const auto given = colours.next(0, {cluster(), cluster(), cluster()}, {1, 2, 3});
  EXPECT_EQ(std::set(given.begin(), given.end()).size(), 3u);
}

TEST(ClusterColours, FollowTheTracks) {
  ClusterColours colours(4);
  const auto before = colours.next(0, {cluster(), cluster(), cluster()}, {1, 2, 3});
  const auto after = colours.next(0.1, {cluster(), cluster(), cluster()}, {3, 4, 1});
  EXPECT_EQ(after[0], before[2]);
  EXPECT_EQ(after[2], before[0]);
  EXPECT_EQ(std::set<std::size_t>({before[0], before[1], before[2], after[1]}).size(), 4u);
}

TEST(ClusterColours, OutlastAnOcclusion) {
  ClusterColours colours(4);
  const auto before = colours.next(0, {cluster(), cluster()}, {1, 2});
  colours.next(1, {cluster()}, {2});
  EXPECT_EQ(colours.next(3, {cluster(), cluster()}, {2, 1})[1], before[0]);
}

TEST(ClusterColours, AreForgottenInTime) {
  ClusterColours colours(2);
  const auto before = colours.next(0, {cluster(), cluster(30)}, {1, 2});
  for (const double time : {1, 2, 3}) colours.next(time, {cluster(30)}, {2});
  // The first was last seen 6 s ago: a third cluster may take its colour.
  EXPECT_EQ(colours.next(6, {cluster(30), cluster()}, {2, 3})[1], before[0]);
}

TEST(ClusterColours, ShareTheColourOfTheFewestVoxels) {
  ClusterColours colours(2);
  const auto given = colours.next(0, {cluster(50), cluster(1), cluster(20)}, {1, 2, 3});
  EXPECT_NE(given[0], given[1]);
  EXPECT_EQ(given[2], given[1]);
}

}  // namespace
}  // namespace experiments
