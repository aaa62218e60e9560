#include "ldm/objects/view.h"

#include <gtest/gtest.h>

#include "ldm/objects/panorama.h"
#include "tests/ldm/objects/lidar.h"

namespace ldm {
namespace {

TEST(View, HoldsColumnsFromRightToLeftByHand) {
  // Two returns above one another straight ahead, 2 and 2.04 m away, and one to the left of them.
  const View view = view_of(
      {1, 0}, std::vector<Eigen::Vector3d>{{3, -0.1, 0.5}, {3.04, -0.102, 0.6}, {3, 0.1, 0.5}});
  ASSERT_EQ(view.slices.size(), 1u);
  EXPECT_EQ(view.slices[0].level, 1);  // 0.4 m to 0.8 m
  ASSERT_EQ(view.slices[0].columns.size(), 2u);
  const Column& right = view.slices[0].columns[0];
  EXPECT_EQ(right.returns, 2);
  EXPECT_NEAR(right.point.x(), 3.02, 1e-3);
  EXPECT_NEAR(right.point.y(), -0.101, 1e-3);
  EXPECT_GT(view.slices[0].columns[1].bearing, right.bearing);
  EXPECT_NEAR(view.width(), 0.2, 5e-3);
}

TEST(View, ColumnsAreTheFrontOfWhatIsBehindOneAnother) {
  const View view =
      view_of({0, 0}, std::vector<Eigen::Vector3d>{{2, 0, 0.1}, {2.02, 0, 0.3}, {2.5, 0, 0.35}});
  ASSERT_EQ(view.slices.size(), 1u);
  ASSERT_EQ(view.slices[0].columns.size(), 1u);
  EXPECT_EQ(view.slices[0].columns[0].returns, 2);
  EXPECT_NEAR(view.slices[0].columns[0].range, 2.01, 1e-9);
}

/// Rings on a roof stay where they are while a car drives on below them.
TEST(View, LeavesLevelSurfacesOut) {
  const View view =
      view_of({0, 0}, std::vector<Eigen::Vector3d>{{2, 0, 0.21}, {2.5, 0, 0.2}, {3, 0, 0.2}});
  EXPECT_TRUE(view.slices.empty());
}

TEST(View, CentreOfWhatIsSquareAndSeenFromTheFront) {
  NoisyLidar lidar(0);
  const View view = view_of({0, 0}, lidar.returns({0, 0, 1}, {{{3, 0.5, 1}, {0.4, 0.4, 1}}}));
  EXPECT_NEAR(view.centre().x(), 3, 0.05);
  EXPECT_NEAR(view.centre().y(), 0.5, 0.05);
}

class PanoramaTest : public testing::Test {
 protected:
  /// The edges of the slice at 1 m of the first box, right and left.
  static std::array<bool, 2> edges(const Box& box, const std::vector<Box>& others) {
    NoisyLidar lidar(0);
    std::vector<Box> all = others;
    all.push_back(box);
    std::vector<Eigen::Vector3d> points = lidar.returns({0, 0, 1}, all);
    std::vector<Eigen::Vector3d> own;
    for (const Eigen::Vector3d& p : points) {
      if (((p - box.centre).cwiseAbs().array() < box.size.array() / 2 + 0.01).all()) {
        own.push_back(p);
      }
    }
    View view = view_of({0, 0}, own);
    Panorama panorama;
    panorama.fill({0, 0}, points);
    panorama.mark_edges(view);
    for (const Slice& slice : view.slices) {
      if (slice.level == 2) return slice.edges;
    }
    ADD_FAILURE();
    return {};
  }
  const Box box_{{3, 0, 1}, {0.4, 0.4, 1}};
};

TEST_F(PanoramaTest, WhatStandsAloneHasBothEdges) {
  EXPECT_EQ(edges(box_, {}), (std::array{true, true}));
}

TEST_F(PanoramaTest, WhatIsBehindHidesNoEdge) {
  EXPECT_EQ(edges(box_, {{{5, 0, 1}, {0.2, 3, 1}}}), (std::array{true, true}));
}

TEST_F(PanoramaTest, WhatIsNearerHidesTheEdgeBesideIt) {
  EXPECT_EQ(edges(box_, {{{1.5, 0.15, 1}, {0.2, 0.2, 1}}}), (std::array{true, false}));
}

TEST_F(PanoramaTest, OnlyTheEndsOfTheWholeAreEdges) {
  NoisyLidar lidar(0);
  const std::vector<Eigen::Vector3d> points =
      lidar.returns({0, 0, 1}, {{{3, 0, 0.6}, {0.4, 1, 0.4}}, {{3, 0, 1}, {0.4, 0.4, 0.4}}});
  View view = view_of({0, 0}, points);
  Panorama panorama;
  panorama.fill({0, 0}, points);
  panorama.mark_edges(view);
  for (const Slice& slice : view.slices) {
    EXPECT_EQ(slice.edges[0], slice.level == 1) << slice.level;
    EXPECT_EQ(slice.edges[1], slice.level == 1) << slice.level;
  }
}

TEST(Panorama, KeepsTheNearestOfADirection) {
  Panorama panorama;
  panorama.fill({1, 1}, std::vector<Eigen::Vector3d>{{1, -4, 0}, {1, -2, 5}, {-1, 1, 0}});
  EXPECT_FLOAT_EQ(panorama.nearest({0, -1}), 3);
  EXPECT_FLOAT_EQ(panorama.nearest({-3, 0}), 2);
  EXPECT_TRUE(std::isinf(panorama.nearest({1, 1})));
}

}  // namespace
}  // namespace ldm
