#include "experiments/metrics/occupancy_score.h"

#include <gtest/gtest.h>

#include "experiments/metrics/scores.h"
#include "tests/experiments/metrics/tiny_world.h"

namespace experiments {
namespace {

double score(const Tallies& tallies, std::string_view name) {
  for (const Score& row : scores()) {
    if (row.name == name) return row.value(tallies).value();
  }
  ADD_FAILURE() << "no score " << name;
  return 0;
}

/// 5^3 voxels; a wall of two solid voxels (1..2, 1, 1), of which a ray sees (1, 1, 1). The map has
/// (1, 1, 1) right, misses (2, 1, 1), and calls occupied (3, 1, 1), beside the wall, and (4, 4, 4),
/// far from it. (0, 0, 0) is free with P = 0.2; everything else is unknown.
class OccupancyScore : public testing::Test {
 protected:
  OccupancyScore() {
    datasets::Truth truth;
    truth.objects = {box_object(0, {1, 1, 1}, {2, 1, 1})};
    truth.noise_free_hits = {centre({1, 1, 1})};
    ldm::LocalMap map = unknown_map(5);
    map.occupancy[map.window.index({1, 1, 1})] = 0.9f;
    map.occupancy[map.window.index({3, 1, 1})] = 0.75f;
    map.occupancy[map.window.index({4, 4, 4})] = 0.6f;
    map.occupancy[map.window.index({0, 0, 0})] = 0.2f;
    TruthGrid grid;
    grid.fill(truth, map.window, map.resolution);
    tallies.occupancy.add(map, grid);
  }
  Tallies tallies;
};

TEST_F(OccupancyScore, CountsFalseVoxelsByHand) {
  EXPECT_EQ(score(tallies, "case1_voxels"), 1);
  EXPECT_EQ(score(tallies, "case2_voxels"), 2);
  EXPECT_EQ(score(tallies, "case1_visible_voxels"), 0);
  EXPECT_EQ(score(tallies, "case2_grown_voxels"), 1);
  EXPECT_EQ(score(tallies, "mixed_voxels_per_frame"), 1);
}

// Eq. (18)
TEST_F(OccupancyScore, AccuracyIsTheShareOfVoxelsInTheirTrueState) {
  EXPECT_DOUBLE_EQ(score(tallies, "accuracy_pct"), 100.0 * 122 / 125);
  EXPECT_DOUBLE_EQ(score(tallies, "accuracy_visible_pct"), 100.0 * 123 / 125);
}

TEST_F(OccupancyScore, PrecisionRecallAndF1) {
  EXPECT_DOUBLE_EQ(score(tallies, "precision"), 1.0 / 3);
  EXPECT_DOUBLE_EQ(score(tallies, "precision_near"), 2.0 / 3);
  EXPECT_DOUBLE_EQ(score(tallies, "recall"), 1.0 / 2);
  EXPECT_DOUBLE_EQ(score(tallies, "f1"), 2.0 / 5);
}

// Seen: (1, 1, 1); invented: (3, 1, 1) and (4, 4, 4); the hidden solid voxel (2, 1, 1) is left out.
TEST_F(OccupancyScore, IntersectionOverUnionIsOfVisibleVoxels) {
  EXPECT_DOUBLE_EQ(score(tallies, "iou_visible"), 1.0 / 3);
}

TEST_F(OccupancyScore, AHiddenSolidVoxelCalledOccupiedIsNoFaultOfTheIntersection) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {1, 1, 1}, {2, 1, 1})};
  truth.noise_free_hits = {centre({1, 1, 1}), centre({0, 3, 3})};
  ldm::LocalMap map = unknown_map(5);
  add_cluster(map, {{1, 1, 1}, {2, 1, 1}});
  TruthGrid grid;
  grid.fill(truth, map.window, map.resolution);
  Tallies one;
  one.occupancy.add(map, grid);
  EXPECT_DOUBLE_EQ(score(one, "iou_visible"), 1.0 / 2);  // (0, 3, 3) is missed
}

TEST(OccupancyScores, AMapThatKnowsNothingWinsTheAccuracyOnly) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {1, 1, 1}, {2, 1, 1})};
  truth.noise_free_hits = {centre({1, 1, 1})};
  const ldm::LocalMap map = unknown_map(5);
  TruthGrid grid;
  grid.fill(truth, map.window, map.resolution);
  Tallies nothing;
  nothing.occupancy.add(map, grid);
  EXPECT_DOUBLE_EQ(score(nothing, "accuracy_pct"), 100.0 * 123 / 125);
  EXPECT_EQ(score(nothing, "f1"), 0);
  EXPECT_EQ(score(nothing, "iou_visible"), 0);
}

TEST_F(OccupancyScore, BrierIsOverKnownVoxels) {
  const double expected = (0.1 * 0.1 + 0.75 * 0.75 + 0.6 * 0.6 + 0.2 * 0.2) / 4;
  EXPECT_NEAR(score(tallies, "brier"), expected, 1e-7);
}

TEST(OccupancyScores, OfNothingAreNull) {
  for (const Score& row : scores()) EXPECT_FALSE(row.value(Tallies{})) << row.name;
}

}  // namespace
}  // namespace experiments
