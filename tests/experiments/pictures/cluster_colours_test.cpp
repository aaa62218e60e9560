#include "experiments/pictures/cluster_colours.h"

#include <gtest/gtest.h>

#include <set>

namespace experiments {
namespace {

ldm::Cluster cluster(std::int64_t id, int voxels = 10) {
  ldm::Cluster cluster;
  cluster.id = id;
  cluster.voxels = voxels;
  return cluster;
}

TEST(ClusterColours, NewObjectsTakeDifferentColours) {
  ClusterColours colours(3);
  const auto given = colours.next(0, {cluster(1), cluster(2), cluster(3)});
  EXPECT_EQ(std::set(given.begin(), given.end()).size(), 3u);
}

TEST(ClusterColours, FollowTheObjects) {
  ClusterColours colours(4);
  const auto before = colours.next(0, {cluster(1), cluster(2), cluster(3)});
  const auto after = colours.next(0.1, {cluster(3), cluster(4), cluster(1)});
  EXPECT_EQ(after[0], before[2]);
  EXPECT_EQ(after[2], before[0]);
  EXPECT_EQ(std::set<std::size_t>({before[0], before[1], before[2], after[1]}).size(), 4u);
}

TEST(ClusterColours, OutlastAnOcclusion) {
  ClusterColours colours(4);
  const auto before = colours.next(0, {cluster(1), cluster(2)});
  colours.next(1, {cluster(2)});
  EXPECT_EQ(colours.next(3, {cluster(2), cluster(1)})[1], before[0]);
}

TEST(ClusterColours, AreForgottenInTime) {
  ClusterColours colours(2);
  const auto before = colours.next(0, {cluster(1), cluster(2, 30)});
  for (const double time : {1, 2, 3}) colours.next(time, {cluster(2, 30)});
  // The first was last seen 6 s ago: a third cluster may take its colour.
  EXPECT_EQ(colours.next(6, {cluster(2, 30), cluster(3)})[1], before[0]);
}

TEST(ClusterColours, ShareTheColourOfTheFewestVoxels) {
  ClusterColours colours(2);
  const auto given = colours.next(0, {cluster(1, 50), cluster(2, 1), cluster(3, 20)});
  EXPECT_NE(given[0], given[1]);
  EXPECT_EQ(given[2], given[1]);
}

}  // namespace
}  // namespace experiments
