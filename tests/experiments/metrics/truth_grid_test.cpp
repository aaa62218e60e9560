#include "experiments/metrics/truth_grid.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/tiny_world.h"

namespace experiments {
namespace {

TEST(TruthGrid, KnowsSolidAndVisibleVoxels) {
  datasets::Truth truth;
  truth.objects = {box_object(7, {1, 1, 1}, {2, 1, 1})};
  truth.noise_free_hits = {centre({0, 1, 1})};
  TruthGrid grid;
  grid.fill(truth, {{0, 0, 0}, {5, 5, 5}}, 1);
  EXPECT_EQ(grid.objects(), 1u);
  EXPECT_TRUE(grid.solid({1, 1, 1}));
  EXPECT_EQ(grid.object({2, 1, 1}), 0);
  EXPECT_FALSE(grid.solid({3, 1, 1}));
  EXPECT_TRUE(grid.visible({0, 1, 1}));
  EXPECT_FALSE(grid.visible({1, 1, 1}));
}

TEST(TruthGrid, ListsTheVoxelsOfWhatMoves) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {1, 1, 1}, {2, 1, 1}), box_object(1, {2, 1, 1}, {3, 1, 1}),
                   box_object(2, {4, 4, 3}, {9, 9, 3}), box_object(3, {0, -5, 0}, {0, -5, 0})};
  truth.objects[0].dynamic = false;
  for (std::size_t i = 1; i < 4; ++i) truth.objects[i].dynamic = true;
  TruthGrid grid;
  grid.fill(truth, {{0, 0, 0}, {5, 5, 5}}, 1);
  // (2, 1, 1) belongs to the object that stands still.
  EXPECT_EQ(grid.moving(), (std::vector<ldm::VoxelIndex>{{3, 1, 1}, {4, 4, 3}}));
}

TEST(TruthGrid, NearIsTheVoxelAndItsTwentySixNeighbours) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {1, 1, 1}, {1, 1, 1}), box_object(1, {3, 1, 1}, {3, 1, 1})};
  TruthGrid grid;
  grid.fill(truth, {{0, 0, 0}, {5, 5, 5}}, 1);
  EXPECT_EQ(grid.objects_near({0, 0, 0}).count, 1u);
  EXPECT_EQ(grid.objects_near({2, 2, 2}).count, 2u);
  EXPECT_EQ(grid.objects_near({4, 2, 2}).objects[0], 1);
  EXPECT_EQ(grid.objects_near({1, 1, 3}).count, 0u);
}

TEST(TruthGrid, AnObjectJustOutsideTheWindowIsNear) {
  datasets::Truth truth;
  truth.objects = {box_object(0, {-1, 2, 2}, {-1, 2, 2})};
  TruthGrid grid;
  grid.fill(truth, {{0, 0, 0}, {5, 5, 5}}, 1);
  EXPECT_EQ(grid.objects_near({0, 1, 1}).count, 1u);
  EXPECT_EQ(grid.objects_near({1, 2, 2}).count, 0u);
}

}  // namespace
}  // namespace experiments
