#include "experiments/metrics/ghost_score.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/tiny_world.h"

namespace experiments {
namespace {

/// A map of 10^3 voxels, and an object that moves along x at y = z = 4.
class GhostScore : public testing::Test {
 protected:
  /// @param first, last voxels of the object along x
  /// @param occupied places along x
  /// @param origin of the map along x
  void frame(double time, int first, int last, const std::vector<int>& occupied, int origin = 0,
             bool dynamic = true) {
    datasets::Truth truth;
    truth.objects = {box_object(3, {first, 4, 4}, {last, 4, 4})};
    truth.objects[0].dynamic = dynamic;
    ldm::LocalMap map = unknown_map(10);
    map.window.origin.x() = origin;
    for (const int x : occupied) map.occupancy[map.window.index({x, 4, 4})] = 0.9F;
    TruthGrid grid;
    grid.fill(truth, map.window, map.resolution);
    tally.add(time, map, grid);
  }

  GhostTally tally;
};

// The object leaves voxel 2 for 3, 5 and 7. Beside the object a voxel is no ghost yet.
TEST_F(GhostScore, CountsWhatIsLeftUntilItIsCleared) {
  frame(0.0, 2, 2, {2});
  frame(0.1, 3, 3, {2, 3});
  EXPECT_EQ(tally.ghosts(), 0);
  frame(0.2, 5, 5, {2, 5});  // 3 is cleared after 0.1 s
  EXPECT_EQ(tally.ghosts(), 1);
  frame(0.3, 7, 7, {2, 5, 7});
  EXPECT_EQ(tally.ghosts(), 3);
  frame(0.4, 7, 7, {7});  // 2 is cleared after 0.4 s, 5 after 0.2 s
  EXPECT_EQ(tally.ghosts(), 3);
  EXPECT_EQ(tally.frames(), 5);
  tally.finish();
  EXPECT_DOUBLE_EQ(tally.time_to_clear().value(), 0.4);
}

TEST_F(GhostScore, OneThatIsOccupiedAgainIsNoGhost) {
  frame(0.0, 2, 2, {2});
  frame(0.1, 5, 5, {});
  frame(0.2, 5, 5, {2});
  EXPECT_EQ(tally.ghosts(), 0);
}

TEST_F(GhostScore, WhatTheMapDidNotKnowOrNothingHeldIsNotLeft) {
  frame(0.0, 2, 2, {7});
  frame(0.1, 5, 5, {2, 7});
  frame(0.2, 5, 5, {2, 7});
  EXPECT_EQ(tally.ghosts(), 0);
  tally.finish();
  EXPECT_FALSE(tally.time_to_clear());
}

TEST_F(GhostScore, AnObjectThatNeverMovesLeavesNothing) {
  frame(0.0, 2, 2, {2}, 0, false);
  frame(0.1, 5, 5, {2}, 0, false);
  EXPECT_EQ(tally.ghosts(), 0);
}

// Of ten, eight are cleared after 0.1 s, so 2/10 remain; one is solid again after 0.2 s; the last
// one is cleared after 0.3 s, so 2/10 * (1 - 1/1) remain.
TEST_F(GhostScore, WhatIsSolidAgainCountsUntilThen) {
  frame(0.0, 0, 9, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  frame(0.1, 20, 20, {0, 9});
  EXPECT_EQ(tally.ghosts(), 2);
  frame(0.2, 9, 9, {0});
  EXPECT_EQ(tally.ghosts(), 3);
  frame(0.3, 9, 9, {});
  tally.finish();
  EXPECT_DOUBLE_EQ(tally.time_to_clear().value(), 0.3);
}

TEST_F(GhostScore, NineOfTenAreEnough) {
  frame(0.0, 0, 9, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  frame(0.1, 20, 20, {0, 9});
  frame(0.2, 20, 20, {0});
  frame(0.3, 20, 20, {0});
  tally.finish();
  EXPECT_DOUBLE_EQ(tally.time_to_clear().value(), 0.2);
}

TEST_F(GhostScore, WhatTheMapLeavesBehindOrTheEndMeetsIsNotCleared) {
  frame(0.0, 2, 2, {2});
  frame(0.1, 5, 5, {2, 5});
  EXPECT_EQ(tally.ghosts(), 1);
  frame(0.2, 8, 8, {5, 8}, 3);  // without voxel 2
  EXPECT_EQ(tally.ghosts(), 2);
  tally.finish();  // 5 is still there
  EXPECT_FALSE(tally.time_to_clear());
}

}  // namespace
}  // namespace experiments
