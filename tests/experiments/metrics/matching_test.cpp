#include "experiments/metrics/matching.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/tiny_world.h"

namespace experiments {
namespace {

Matching match_tiny(const datasets::Truth& truth, const ldm::LocalMap& map) {
  TruthGrid grid;
  grid.fill(truth, map.window, map.resolution);
  return match(map, grid);
}

TEST(Matching, TakesTheClusterOfLargestOverlapWithTheGrownObject) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {3, 3, 3}, {3, 3, 3})};
  ldm::LocalMap map = unknown_map(8);
  add_cluster(map, {{3, 3, 3}, {7, 3, 3}});  // one voxel in the object
  add_cluster(map, {{2, 2, 2}, {2, 2, 3}});  // two beside it: these count as well
  const Matching matching = match_tiny(truth, map);
  EXPECT_EQ(matching.objects[0].cluster, 1u);
  EXPECT_EQ(matching.clusters_without_object, 0);
}

TEST(Matching, OfEqualOverlapsTheFirstWins) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {3, 3, 3}, {3, 3, 3})};
  ldm::LocalMap map = unknown_map(8);
  add_cluster(map, {{2, 3, 3}});
  add_cluster(map, {{4, 3, 3}});
  EXPECT_EQ(match_tiny(truth, map).objects[0].cluster, 0u);
}

TEST(Matching, CountsClustersWithoutObject) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {1, 1, 1}, {1, 1, 1})};
  ldm::LocalMap map = unknown_map(8);
  add_cluster(map, {{3, 1, 1}});  // two voxels away
  add_cluster(map, {{6, 6, 6}});
  const Matching matching = match_tiny(truth, map);
  EXPECT_FALSE(matching.objects[0].cluster);
  EXPECT_EQ(matching.clusters_without_object, 2);
}

TEST(Matching, OneClusterMayStandForTwoObjects) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {1, 1, 1}, {1, 1, 1}), box_object(1, {3, 1, 1}, {3, 1, 1})};
  ldm::LocalMap map = unknown_map(8);
  add_cluster(map, {{1, 1, 1}, {2, 1, 1}, {3, 1, 1}});
  const Matching matching = match_tiny(truth, map);
  EXPECT_EQ(matching.objects[0].cluster, 0u);
  EXPECT_EQ(matching.objects[1].cluster, 0u);
}

TEST(Matching, TellsObjectsInTheMapAndVisibleOnes) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {1, 1, 1}, {1, 1, 1}), box_object(1, {5, 5, 5}, {5, 5, 5}),
                   box_object(2, {20, 0, 0}, {20, 0, 0})};
  truth.noise_free_hits = {centre({0, 1, 1})};  // the surface may lie in the voxel beside
  const Matching matching = match_tiny(truth, unknown_map(8));
  EXPECT_TRUE(matching.objects[0].in_map);
  EXPECT_TRUE(matching.objects[0].visible);
  EXPECT_TRUE(matching.objects[1].in_map);
  EXPECT_FALSE(matching.objects[1].visible);
  EXPECT_FALSE(matching.objects[2].in_map);
}

}  // namespace
}  // namespace experiments
