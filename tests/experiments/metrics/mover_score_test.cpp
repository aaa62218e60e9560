#include "experiments/metrics/mover_score.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/tiny_world.h"

namespace experiments {
namespace {

/// Object 0 moves in voxel (2, 2, 2), object 1 stands in (6, 6, 6).
datasets::Frame frame() {
  datasets::Frame frame;
  frame.truth.emplace();
  frame.truth->objects = {box_object(0, {2, 2, 2}, {2, 2, 2}), box_object(1, {6, 6, 6}, {6, 6, 6})};
  frame.truth->objects[0].velocity = {1, 0, 0};
  frame.truth->noise_free_hits = {centre({2, 2, 2}), centre({6, 6, 6})};
  return frame;
}

TruthGrid grid_of(const datasets::Frame& frame, const ldm::LocalMap& map) {
  TruthGrid grid;
  grid.fill(*frame.truth, map.window, map.resolution);
  return grid;
}

/// Two returns in one voxel count once; one beside the mover counts, one on what stands does not.
TEST(MoverScore, CountsVoxelsWithReturnsOnMovers) {
  datasets::Frame seen = frame();
  seen.scan.points = {centre({2, 2, 2}), centre({2, 2, 2}), centre({1, 2, 2}),
                      centre({6, 6, 6}), centre({0, 0, 0}), centre({20, 0, 0})};
  ldm::LocalMap map = unknown_map(8);
  map.occupancy[map.window.index({2, 2, 2})] = 0.9F;
  MoverTally tally;
  tally.add_returns(seen, map, grid_of(seen, map));
  EXPECT_EQ(tally.voxels_found().count(), 2);
  EXPECT_DOUBLE_EQ(*tally.voxels_found().value(), 0.5);
}

TEST(MoverScore, DynamicClustersAreMoversOrFalse) {
  const datasets::Frame seen = frame();
  ldm::LocalMap map = unknown_map(8);
  add_cluster(map, {{2, 2, 2}, {2, 2, 3}});
  add_cluster(map, {{1, 1, 1}});  // a fragment of the mover
  add_cluster(map, {{6, 6, 6}});
  add_cluster(map, {{7, 0, 0}});
  map.clusters[0].dynamic = map.clusters[1].dynamic = map.clusters[2].dynamic = true;
  MoverTally tally;
  tally.add_clusters(*seen.truth, map, match(map, grid_of(seen, map)));
  EXPECT_EQ(tally.called_dynamic().value(), 1);
  EXPECT_EQ(tally.false_movers().value(), 2);
  map.clusters[0].dynamic = map.clusters[1].dynamic = map.clusters[2].dynamic = false;
  tally.add_clusters(*seen.truth, map, match(map, grid_of(seen, map)));
  EXPECT_EQ(tally.called_dynamic().value(), 0.5);
  EXPECT_EQ(tally.false_movers().value(), 1);
}

}  // namespace
}  // namespace experiments
