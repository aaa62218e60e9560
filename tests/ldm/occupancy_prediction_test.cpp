#include "ldm/occupancy_prediction.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/ldm/moving_clusters.h"

namespace ldm {
namespace {

using Voxels = std::vector<VoxelIndex>;

/// The ways to move less than a voxel: 0.5 m/s at 10 Hz are a third of a voxel of 0.15 m.
class SubVoxelTest : public testing::Test {
 protected:
  /// Where a voxel of log-odds 2 is, frame after frame, counted in x from where it was.
  std::vector<int> path(SubVoxelMotion way, float speed, int frames, double min_speed = 0) {
    MovingClusters clusters({48, 5, 5}, {way, min_speed});
    clusters.set({-20, 0, 0}, 2);
    std::vector<int> at;
    for (int k = 0; k < frames; ++k) {
      clusters.find({Velocity(speed, 0, 0)});
      clusters.predict(0.1);
      const Voxels occupied = clusters.above(0);
      EXPECT_EQ(occupied.size(), 1u);
      if (occupied.empty()) break;
      EXPECT_EQ(clusters.at(occupied[0]), 2);
      at.push_back(occupied[0].x() + 20);
    }
    return at;
  }
};

TEST_F(SubVoxelTest, NoneStays) {
  EXPECT_EQ(path(SubVoxelMotion::kNone, 3, 3), (std::vector<int>{0, 0, 0}));
}

TEST_F(SubVoxelTest, RoundLosesTheRestOfEachFrame) {
  EXPECT_EQ(path(SubVoxelMotion::kRound, 0.5, 6), (std::vector<int>{0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(path(SubVoxelMotion::kRound, 0.8F, 3), (std::vector<int>{1, 2, 3}));  // 0.53 voxels
  EXPECT_EQ(path(SubVoxelMotion::kRound, -0.8F, 3), (std::vector<int>{-1, -2, -3}));
}

TEST_F(SubVoxelTest, ResidualCarriesTheRest) {
  // 1/3 rounds to 0, 2/3 to 1; then -1/3 + 1/3 leaves nothing: one voxel in three frames.
  EXPECT_EQ(path(SubVoxelMotion::kResidual, 0.5, 6), (std::vector<int>{0, 1, 1, 1, 2, 2}));
  EXPECT_EQ(path(SubVoxelMotion::kResidual, -0.5, 6), (std::vector<int>{0, -1, -1, -1, -2, -2}));
  EXPECT_EQ(path(SubVoxelMotion::kResidual, 0.5, 60).back(), 20);
  EXPECT_EQ(path(SubVoxelMotion::kResidual, 2.1F, 5), (std::vector<int>{1, 3, 4, 6, 7}));
}

TEST_F(SubVoxelTest, SlowerThanTheGateStaysAndForgetsItsRest) {
  EXPECT_EQ(path(SubVoxelMotion::kResidual, 0.5, 6, 0.6), std::vector<int>(6, 0));
  EXPECT_EQ(path(SubVoxelMotion::kRound, 0.8F, 3, 0.9), std::vector<int>(3, 0));
  EXPECT_EQ(path(SubVoxelMotion::kResidual, 0.5, 3, 0.5), (std::vector<int>{0, 1, 1}));

  MovingClusters clusters({48, 5, 5}, {SubVoxelMotion::kResidual, 0.4});
  clusters.set({0, 0, 0}, 2);
  for (const float speed :
       {0.5F, 0.3F, 0.5F}) {  // the slow frame between them loses the first rest
    clusters.find({Velocity(speed, 0, 0)});
    clusters.predict(0.1);
  }
  EXPECT_EQ(clusters.above(0), (Voxels{{0, 0, 0}}));
}

/// The moved cube of a voxel shares its probability out to the voxels it overlaps.
TEST_F(SubVoxelTest, TrilinearSharesProbabilities) {
  MovingClusters clusters({48, 5, 5}, {SubVoxelMotion::kTrilinear, 0}, -1);
  clusters.set({0, 0, 0}, 2);  // P = 0.880797
  clusters.find({Velocity(0.5, 0, 0)});
  clusters.predict(0.1);
  EXPECT_NEAR(clusters.at({0, 0, 0}), 0.352394, 1e-4);   // 2/3 P = 0.587198
  EXPECT_NEAR(clusters.at({1, 0, 0}), -0.877968, 1e-4);  // 1/3 P = 0.293599
  EXPECT_EQ(clusters.at({-1, 0, 0}), -1);
  EXPECT_EQ(clusters.at({2, 0, 0}), -1);
}

TEST_F(SubVoxelTest, TrilinearAddsSharesUpWithinTheClamps) {
  MovingClusters clusters({48, 5, 5}, {SubVoxelMotion::kTrilinear, 0}, -2);
  for (int x = 0; x <= 2; ++x) clusters.set({x, 0, 0}, 3.5);  // P = 0.970688
  clusters.find({Velocity(-0.15F, 0, 0)});
  clusters.predict(0.1);                           // a tenth of a voxel down
  EXPECT_EQ(clusters.at({-1, 0, 0}), -2);          // 0.097069: -2.23 is below the clamp
  EXPECT_NEAR(clusters.at({0, 0, 0}), 3.5, 1e-3);  // 0.9 P + 0.1 P
  EXPECT_NEAR(clusters.at({1, 0, 0}), 3.5, 1e-3);
  EXPECT_NEAR(clusters.at({2, 0, 0}), 1.933343, 1e-3);  // 0.9 P = 0.873620
  for (int k = 0; k < 3; ++k) {
    for (const VoxelIndex& v : clusters.above(-2.1F)) EXPECT_LE(clusters.at(v), 3.5F);
    clusters.find({Velocity(-0.15F, 0, 0)});
    clusters.predict(0.1);
  }
}

TEST_F(SubVoxelTest, TrilinearByWholeVoxelsMovesWhatIsThere) {
  MovingClusters clusters({48, 5, 5}, {SubVoxelMotion::kTrilinear, 0});
  clusters.set({0, 0, 0}, 2);
  clusters.find({Velocity(3, 0, -1.5)});
  clusters.predict(0.1);
  EXPECT_NEAR(clusters.at({2, 0, -1}), 2, 1e-3);
  EXPECT_NEAR(clusters.at({0, 0, 0}), 0, 1e-3);
}

TEST_F(SubVoxelTest, TrilinearSharesAmongEightVoxels) {
  MovingClusters clusters({9, 9, 9}, {SubVoxelMotion::kTrilinear, 0}, -2);
  clusters.set({0, 0, 0}, 3.5);
  clusters.find({Velocity(0.75, 0.75, 0.75)});  // half a voxel along each axis
  clusters.predict(0.1);
  EXPECT_EQ(clusters.at({0, 0, 0}), 0);  // vacated; an eighth of P is less than unknown
  for (const VoxelIndex& v : Voxels{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}}) {
    EXPECT_NEAR(clusters.at(v), -1.979839, 1e-4);  // P / 8 = 0.121336
  }
  EXPECT_EQ(clusters.above(-1.99F).size(), 8u);
}

class OccupancyPredictionTest : public testing::Test {
 protected:
  MovingClusters clusters_{{9, 9, 9}, {SubVoxelMotion::kRound, 0}};
};

/// Fig. 3: both clusters move to the right, one of them up, the other down.
TEST_F(OccupancyPredictionTest, ClustersOfFigure3MoveEachItsWay) {
  clusters_.set({-4, -3, 0}, 1);
  clusters_.set({-4, -2, 0}, 2);
  clusters_.set({-4, 2, 0}, 3);
  clusters_.find({Velocity(1.5, -1.5, 0), Velocity(3, 1.5, 0)});
  clusters_.predict(0.1);
  EXPECT_EQ(clusters_.above(0), (Voxels{{-3, -4, 0}, {-3, -3, 0}, {-2, 3, 0}}));
  EXPECT_EQ(clusters_.at({-3, -4, 0}), 1);
  EXPECT_EQ(clusters_.at({-3, -3, 0}), 2);
  EXPECT_EQ(clusters_.at({-2, 3, 0}), 3);
}

TEST_F(OccupancyPredictionTest, VacatedVoxelsAreUnknown) {
  for (int x = -1; x <= 1; ++x) clusters_.set({x, 0, 0}, static_cast<float>(3 + 0.1 * x));
  clusters_.set({2, 0, 0}, -1);
  clusters_.find({Velocity(1.5, 0, 0)});
  clusters_.predict(0.1);
  EXPECT_EQ(clusters_.at({-1, 0, 0}), 0);
  EXPECT_FLOAT_EQ(clusters_.at({0, 0, 0}), 2.9F);
  EXPECT_FLOAT_EQ(clusters_.at({1, 0, 0}), 3.0F);
  EXPECT_FLOAT_EQ(clusters_.at({2, 0, 0}), 3.1F);  // free before
}

TEST_F(OccupancyPredictionTest, WhereTwoMeetTheLargerStays) {
  clusters_.set({-2, 0, 0}, 3);
  clusters_.set({0, 0, 0}, 1);
  clusters_.set({2, 0, 0}, 2);
  clusters_.find({Velocity(3, 0, 0), Velocity(0, 0, 0), Velocity(-3, 0, 0)});
  clusters_.predict(0.1);
  EXPECT_EQ(clusters_.above(0), (Voxels{{0, 0, 0}}));
  EXPECT_EQ(clusters_.at({0, 0, 0}), 3);
}

TEST_F(OccupancyPredictionTest, WhatLeavesTheWindowIsLost) {
  for (const VoxelIndex& v : Voxels{{4, 0, 0}, {-4, 0, 2}, {0, 4, 4}}) clusters_.set(v, 2);
  clusters_.find({Velocity(1.5, 0, 0), Velocity(-1.5, 0, 0), Velocity(0, 1.5, 1.5)});
  clusters_.predict(0.1);
  EXPECT_TRUE(clusters_.above(0).empty());  // nor does it come back at the other end
}

TEST_F(OccupancyPredictionTest, NoTimeNoMotion) {
  for (const SubVoxelMotion way :
       {SubVoxelMotion::kRound, SubVoxelMotion::kResidual, SubVoxelMotion::kTrilinear}) {
    MovingClusters clusters({9, 9, 9}, {way, 0});
    clusters.set({0, 0, 0}, 2);
    clusters.find({Velocity(30, -30, 30)});
    clusters.predict(0);
    EXPECT_EQ(clusters.above(0), (Voxels{{0, 0, 0}}));
    EXPECT_EQ(clusters.at({0, 0, 0}), 2);
  }
}

TEST_F(OccupancyPredictionTest, LongPausesEmptyTheMap) {
  for (const double dt : {1e3, 1e9, 1e300}) {
    MovingClusters clusters({9, 9, 9}, {SubVoxelMotion::kResidual, 0});
    clusters.set({0, 0, 0}, 2);
    clusters.find({Velocity(0.5, 0, 0)});
    clusters.predict(dt);
    EXPECT_TRUE(clusters.above(0).empty());
  }
}

}  // namespace
}  // namespace ldm
