#include "ldm/measurement_flags.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

/// A map of 9 voxels of 0.5 m per axis around voxel 0, the sensor in the middle of that voxel: rays
/// along the axes cross walls at numbers that floating point holds exactly.
class MeasurementFlagsTest : public testing::Test {
 protected:
  MeasurementFlagsTest() {
    scan_.T_world_sensor.translation.setConstant(0.25);
    scan_.T_world_uav = scan_.T_world_sensor;
  }

  void mark(NoReturnRays no_returns = NoReturnRays::kFree, bool shadows = true) {
    flags_.emplace(map_of({9, 9, 9}, 0.5), no_returns, shadows);
    flags_->mark(scan_, window_);
  }
  std::uint8_t at(const VoxelIndex& v) const { return flags_->flags()[window_.index(v)]; }
  /// Flags along x from the sensor's voxel 0 to the border 4.
  std::vector<int> row() const {
    std::vector<int> flags;
    for (int x = 0; x <= 4; ++x) flags.push_back(at({x, 0, 0}));
    return flags;
  }
  std::ptrdiff_t marked() const {
    return std::count_if(flags_->flags().begin(), flags_->flags().end(),
                         [](std::uint8_t f) { return f != flag::kNone; });
  }

  VoxelBox window_{{-4, -4, -4}, {9, 9, 9}};
  Scan scan_;
  std::optional<MeasurementFlags> flags_;
};

TEST_F(MeasurementFlagsTest, FreeBeforeTheReturnShadowBehind) {
  scan_.points = {{1, 0, 0}};
  mark();
  // Voxel 3 begins half a voxel, voxel 4 one and a half behind the middle of voxel 2.
  EXPECT_EQ(row(), (std::vector<int>{flag::kFree, flag::kFree, flag::kOccupied, 252, 250}));
  EXPECT_EQ(marked(), 5);
}

TEST_F(MeasurementFlagsTest, RayAgainstAnAxis) {
  scan_.points = {{0, 0, -0.5F}};
  mark();
  EXPECT_EQ(at({0, 0, 0}), flag::kFree);
  EXPECT_EQ(at({0, 0, -1}), flag::kOccupied);
  EXPECT_EQ(at({0, 0, -2}), 252);
  EXPECT_EQ(at({0, 0, -3}), 250);
  EXPECT_EQ(at({0, 0, -4}), 248);
  EXPECT_EQ(marked(), 5);
}

TEST_F(MeasurementFlagsTest, PointsAreTurnedByThePoseOfTheSensor) {
  // A quarter turn to the left: forward (x) becomes y.
  scan_.T_world_sensor.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  scan_.T_world_sensor.translation = {-0.75, -0.25, 1.25};
  scan_.points = {{0.5F, 0, 0}};
  mark();
  EXPECT_EQ(at({-2, -1, 2}), flag::kFree);
  EXPECT_EQ(at({-2, 0, 2}), flag::kOccupied);
  EXPECT_EQ(at({-2, 1, 2}), 252);
}

TEST_F(MeasurementFlagsTest, RayGoesThroughTheMiddleOfItsVoxel) {
  scan_.points = {{1.2F, 0.2F, -0.24F}};  // off the middle of voxel (2, 0, 0)
  mark();
  EXPECT_EQ(row(), (std::vector<int>{flag::kFree, flag::kFree, flag::kOccupied, 252, 250}));
  EXPECT_EQ(marked(), 5);
}

TEST_F(MeasurementFlagsTest, NoReturnIsFreeUpToTheBorderOrNothing) {
  scan_.no_returns = {{1, 0, 0}};
  mark(NoReturnRays::kFree);
  EXPECT_EQ(row(), std::vector<int>(5, flag::kFree));
  EXPECT_EQ(marked(), 5);
  mark(NoReturnRays::kDrop);
  EXPECT_EQ(marked(), 0);
}

TEST_F(MeasurementFlagsTest, ReturnBeyondTheMapIsFreeUpToTheBorder) {
  scan_.points = {{50, 0, 0}};
  for (const NoReturnRays no_returns : {NoReturnRays::kFree, NoReturnRays::kDrop}) {
    mark(no_returns);
    EXPECT_EQ(row(), std::vector<int>(5, flag::kFree));
    EXPECT_EQ(marked(), 5);
  }
}

TEST_F(MeasurementFlagsTest, HitBeatsCrossingBeatsShadowAndTheNearerShadowWins) {
  scan_.points = {{0.5F, 0, 0}, {1.5F, 0, 0}};
  mark();
  EXPECT_EQ(row(),
            (std::vector<int>{flag::kFree, flag::kOccupied, flag::kFree, flag::kOccupied, 252}));
  std::swap(scan_.points[0], scan_.points[1]);
  mark();
  EXPECT_EQ(row(),
            (std::vector<int>{flag::kFree, flag::kOccupied, flag::kFree, flag::kOccupied, 252}));
}

TEST_F(MeasurementFlagsTest, NoShadowsWhenNobodyNeedsThem) {
  scan_.points = {{1, 0, 0}};
  mark(NoReturnRays::kFree, false);
  EXPECT_EQ(row(), (std::vector<int>{flag::kFree, flag::kFree, flag::kOccupied, 0, 0}));
}

TEST_F(MeasurementFlagsTest, ManyPointsInOneVoxelAreOne) {
  scan_.points = {{1, 0, 0}};
  mark();
  const std::vector<std::uint8_t> one(flags_->flags().begin(), flags_->flags().end());
  scan_.points = {{1, 0, 0}, {1.1F, 0.1F, 0}, {0.9F, -0.2F, 0.2F}, {1, 0, 0}};
  mark();
  EXPECT_TRUE(std::equal(one.begin(), one.end(), flags_->flags().begin()));
}

TEST_F(MeasurementFlagsTest, EachScanStartsAnewInItsWindow) {
  scan_.points = {{1, 0, 0}};
  mark();
  scan_.points.clear();
  flags_->mark(scan_, window_);
  EXPECT_EQ(marked(), 0);
  scan_.points = {{1, 0, 0}};
  window_.origin += VoxelIndex(1, -2, 3);
  flags_->mark(scan_, window_);
  EXPECT_EQ(at({2, 0, 0}), flag::kOccupied);
  EXPECT_EQ(at({1, 0, 0}), flag::kFree);
  EXPECT_EQ(at({5, 0, 0}), 248);
  EXPECT_EQ(marked(), 6);
}

TEST_F(MeasurementFlagsTest, SensorOutsideTheMap) {
  scan_.T_world_sensor.translation.x() = -4.75;  // in voxel -10
  scan_.points = {{4, 0, 0}};                    // in voxel -2
  mark();
  EXPECT_EQ(at({-4, 0, 0}), flag::kFree);
  EXPECT_EQ(at({-3, 0, 0}), flag::kFree);
  EXPECT_EQ(at({-2, 0, 0}), flag::kOccupied);
  EXPECT_EQ(at({-1, 0, 0}), 252);
  EXPECT_EQ(marked(), 9);
  scan_.points = {{12, 0, 0}};  // on the other side
  mark();
  EXPECT_EQ(row(), std::vector<int>(5, flag::kFree));
  EXPECT_EQ(marked(), 9);
  scan_.points = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 0}};  // before the map, and away from it
  scan_.no_returns = {{0, 1, 0}, {-1, 0, 0}};
  mark();
  EXPECT_EQ(marked(), 0);
  scan_.no_returns = {{1, 0, 0}};
  mark();
  EXPECT_EQ(marked(), 9);
}

TEST_F(MeasurementFlagsTest, SensorInsideTheVoxelItHits) {
  scan_.T_world_sensor.translation = {0.3, 0.25, 0.25};
  scan_.points = {{0.05F, 0, 0}};
  mark();
  EXPECT_EQ(at({0, 0, 0}), flag::kOccupied);
  EXPECT_EQ(at({1, 0, 0}), flag::kNone);  // the ray through the middle goes the other way
  EXPECT_GT(at({-1, 0, 0}), 245);
}

TEST_F(MeasurementFlagsTest, SensorInTheVeryMiddleOfTheVoxelItHits) {
  scan_.points = {{0, 0, 0}};
  mark();
  EXPECT_EQ(at({0, 0, 0}), flag::kOccupied);
  EXPECT_EQ(marked(), 1);  // no direction: no shadow
}

TEST_F(MeasurementFlagsTest, TheLargestAndTheSmallestNumbers) {
  scan_.T_world_sensor.rotation << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  scan_.points = {{1e7F, 1e7F, 0}, {1e7F, -1e7F, 1e7F}, {0, 0, -1e7F}, {1e-45F, 0, 0}};
  scan_.no_returns = {{0, 0, 0}, {1e7F, 1e7F, 1e7F}, {0, 1e-45F, 0}};
  mark();
  for (const std::uint8_t f : flags_->flags()) {
    EXPECT_TRUE(f == flag::kNone || f == flag::kFree || f == flag::kOccupied);
  }
  EXPECT_EQ(at({0, 0, 0}), flag::kOccupied);  // the smallest point
}

TEST(ShadowFlagTest, DistanceInHalfVoxels) {
  EXPECT_EQ(flag::shadow_distance(flag::kShadow), 0);
  EXPECT_EQ(flag::shadow_distance(252), 0.5F);
  EXPECT_EQ(flag::shadow_distance(1), 126);
}

TEST(ShadowFlagTest, FarBehindIsAsFarAsAFlagCanSay) {
  MeasurementFlags flags(map_of({300, 5, 5}, 1), NoReturnRays::kFree, true);
  const VoxelBox window{{0, 0, 0}, {300, 5, 5}};
  Scan scan;
  scan.T_world_sensor.translation = {0.5, 2.5, 2.5};
  scan.points = {{1, 0, 0}};
  flags.mark(scan, window);
  const auto at = [&](int x) { return flags.flags()[window.index({x, 2, 2})]; };
  EXPECT_EQ(at(1), flag::kOccupied);
  EXPECT_EQ(at(101), flag::kShadow - 199);  // begins 99.5 voxels behind the middle of voxel 1
  EXPECT_EQ(at(127), 2);
  for (int x = 128; x < 300; ++x) EXPECT_EQ(at(x), 1) << x;
}

}  // namespace
}  // namespace ldm
