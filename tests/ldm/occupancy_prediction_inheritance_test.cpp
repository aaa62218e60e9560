/// What a cluster passes on to the next frame: its sub-voxel rest, and whether it stood still.
#include <gtest/gtest.h>

#include "tests/ldm/moving_clusters.h"

namespace ldm {
namespace {

using Voxels = std::vector<VoxelIndex>;
constexpr PredictionParameters kResidual{SubVoxelMotion::kResidual, 0};

/// 0.6 m/s are 0.4 voxels in 0.1 s, so a cluster that comes with a rest moves in its second frame.
const Velocity kSlow(0.6F, 0, 0);
const Velocity kRest(0, 0, 0);

class InheritanceTest : public testing::Test {
 protected:
  void set_row(int x_begin, int x_end, int y, float l) {
    for (int x = x_begin; x < x_end; ++x) clusters_.set({x, y, 0}, l);
  }
  void frame(const std::vector<Velocity>& velocities) {
    clusters_.find(velocities);
    clusters_.predict(0.1);
  }

  MovingClusters clusters_{{33, 9, 9}, kResidual};
};

TEST_F(InheritanceTest, NewClustersHaveNoRest) {
  set_row(0, 2, 0, 2);
  frame({kSlow});
  set_row(0, 2, 0, 0);
  set_row(5, 7, 0, 2);  // appears elsewhere
  frame({kSlow});
  EXPECT_EQ(clusters_.above(0), (Voxels{{5, 0, 0}, {6, 0, 0}}));
}

TEST_F(InheritanceTest, MergedClusterTakesTheRestOfTheLargerPart) {
  for (const int cut : {2, 6}) {  // where the moving part, below, ends: 2 or 6 voxels of 8
    MovingClusters clusters({33, 9, 9}, kResidual);
    for (int x = 0; x < 9; ++x) {
      if (x != cut) clusters.set({x, 0, 0}, 2);
    }
    clusters.find({kSlow, kRest});
    clusters.predict(0.1);
    clusters.set({cut, 0, 0}, 2);
    clusters.find({kSlow});
    clusters.predict(0.1);
    // With the rest 0.4 of the moving part it is 0.8 voxels on its way, without it 0.4.
    EXPECT_EQ(clusters.above(0).front(), VoxelIndex(cut == 6 ? 1 : 0, 0, 0)) << cut;
    EXPECT_EQ(clusters.above(0).size(), 9u);
  }
}

TEST_F(InheritanceTest, BothPartsOfASplitClusterTakeItsRest) {
  set_row(0, 7, 0, 2);
  frame({kSlow});
  clusters_.set({3, 0, 0}, 0);
  frame({kSlow, kSlow});
  EXPECT_EQ(clusters_.above(0),
            (Voxels{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {5, 0, 0}, {6, 0, 0}, {7, 0, 0}}));
}

TEST_F(InheritanceTest, OverlapIsTakenWhereTheClusterWentTo) {
  set_row(0, 2, 0, 2);
  frame({Velocity(3.6F, 0, 0)});  // 2.4 voxels: moves by 2, keeps 0.4
  ASSERT_EQ(clusters_.above(0), (Voxels{{2, 0, 0}, {3, 0, 0}}));
  frame({kSlow});
  EXPECT_EQ(clusters_.above(0), (Voxels{{3, 0, 0}, {4, 0, 0}}));
}

TEST_F(InheritanceTest, RestsAreKeptPerAxis) {
  set_row(0, 1, 0, 2);
  frame({Velocity(0.6F, -0.6F, 0.3F)});
  frame({Velocity(0.6F, -0.6F, 0.3F)});
  EXPECT_EQ(clusters_.above(0), (Voxels{{1, -1, 0}}));
  frame({Velocity(0.6F, -0.6F, 0.3F)});
  EXPECT_EQ(clusters_.above(0), (Voxels{{1, -1, 1}}));
}

TEST_F(InheritanceTest, TheMapMovesAndTheRestStaysWithTheObject) {
  set_row(0, 2, 0, 2);
  frame({kSlow});
  clusters_.recenter({7, -2, 3});
  frame({kSlow});
  EXPECT_EQ(clusters_.above(0), (Voxels{{1, 0, 0}, {2, 0, 0}}));
}

TEST_F(InheritanceTest, WhatLeftTheMapPassesNothingOn) {
  set_row(-16, -14, 0, 2);
  frame({kSlow});
  clusters_.recenter({2, 0, 0});
  set_row(17, 19, 0, 2);  // new voxels in the same slots
  frame({kSlow});
  EXPECT_EQ(clusters_.above(0), (Voxels{{17, 0, 0}, {18, 0, 0}}));
}

TEST_F(InheritanceTest, KeptAreTheVoxelsOfStaticClustersWhereTheyStandNow) {
  set_row(0, 2, -2, 2);
  set_row(0, 2, 0, 2);
  set_row(0, 2, 2, 2);
  const Velocity creeping(0.15F, 0, 0);  // below the threshold, yet 1.6 voxels in 1.6 s
  clusters_.find({kRest, kSlow, creeping});
  clusters_.predict(1.6);
  EXPECT_EQ(clusters_.kept(), (Voxels{{0, -2, 0}, {1, -2, 0}, {2, 2, 0}, {3, 2, 0}}));
  clusters_.find({kSlow, kSlow, kSlow});
  clusters_.predict(0.1);
  EXPECT_TRUE(clusters_.kept().empty());
}

TEST_F(InheritanceTest, KeptIsForgottenWithTheVoxel) {
  set_row(-16, -13, 0, 2);
  frame({kRest});
  EXPECT_EQ(clusters_.kept().size(), 3u);
  clusters_.recenter({2, 0, 0});
  EXPECT_EQ(clusters_.kept(), (Voxels{{-14, 0, 0}}));
}

}  // namespace
}  // namespace ldm
