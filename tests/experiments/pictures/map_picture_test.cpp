#include "experiments/pictures/map_picture.h"

#include <gtest/gtest.h>

namespace experiments {
namespace {

/// 2 x 2 x 2 voxels of 0.5 m from (1, 0, 0) m on; occupied: (2, 0, 0), (3, 1, 1).
ldm::LocalMap small_map() {
  ldm::LocalMap map;
  map.window = {{2, 0, 0}, {2, 2, 2}};
  map.resolution = 0.5;
  map.occupancy = {0.9F, 0.5F, 0.1F, 0.5F, 0.5F, 0.5F, 0.5F, 0.8F};
  map.labels.assign(8, -1);
  return map;
}

datasets::Frame small_frame() {
  datasets::Frame frame;
  frame.index = 12;
  frame.scan.time = 1.2;
  frame.scan.T_world_sensor.translation = {1, 2, 3};
  frame.scan.points = {{0.5F, 0, 0}};
  return frame;
}

TEST(MapPicture, ShowsOccupiedVoxelsAndThePointsInTheWorld) {
  const Picture picture = picture_of(small_frame(), small_map(), {}, "a map");
  EXPECT_EQ(picture.border.min(), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(picture.border.max(), Eigen::Vector3d(2, 1, 1));
  EXPECT_EQ(picture.cube_edge, 0.5);
  ASSERT_EQ(picture.cubes.size(), 2u);
  EXPECT_EQ(picture.cubes[0].centre, ldm::Point(1.25F, 0.25F, 0.25F));
  EXPECT_EQ(picture.cubes[1].centre, ldm::Point(1.75F, 0.75F, 0.75F));
  ASSERT_EQ(picture.points.size(), 1u);
  EXPECT_EQ(picture.points[0], ldm::Point(1.5F, 2, 3));
}

TEST(MapPicture, WithoutClustersAllIsGrey) {
  const Picture picture = picture_of(small_frame(), small_map(), {}, "a map");
  EXPECT_EQ(picture.cubes[0].colour, picture.cubes[1].colour);
  ASSERT_EQ(picture.cube_keys.size(), 1u);
  EXPECT_EQ(picture.cube_keys[0].text, "occupied voxels");
  EXPECT_TRUE(picture.arrows.empty());
  EXPECT_EQ(picture.arrow_key, "");
  EXPECT_EQ(picture.heading, (std::vector<std::string>{"a map", "t = 1.2 s, frame 12",
                                                       "2 occupied voxels of 0.5 m"}));
}

TEST(MapPicture, ClustersHaveColoursAndTheMovingOnesArrows) {
  ldm::LocalMap map = small_map();
  map.labels[0] = 0;
  map.labels[7] = 1;
  map.clusters = {{.id = 4,
                   .position = {1.25F, 0.25F, 0.25F},
                   .size = {0.5F, 0.5F, 0.5F},
                   .velocity = {0.1F, 0, 0},
                   .voxels = 1,
                   .dynamic = false},
                  {.id = 9,
                   .position = {1.75F, 0.75F, 0.75F},
                   .size = {0.5F, 0.5F, 0.5F},
                   .velocity = {0, -1.5F, 0},
                   .velocity_covariance = Eigen::Vector2f(9, 0.04F).asDiagonal().toDenseMatrix(),
                   .voxels = 1,
                   .dynamic = true}};
  const Picture picture = picture_of(small_frame(), map, {3, 1}, "a map");
  EXPECT_NE(picture.cubes[0].colour, picture.cubes[1].colour);
  EXPECT_EQ(picture_of(small_frame(), map, {1, 3}, "").cubes[0].colour, picture.cubes[1].colour);
  ASSERT_EQ(picture.arrows.size(), 1u);
  const Picture::Arrow& arrow = picture.arrows[0];
  EXPECT_TRUE((arrow.to - arrow.from).isApprox(map.clusters[1].velocity));
  EXPECT_GT(arrow.from.z(), 1.0F);  // above the cluster
  EXPECT_EQ(arrow.label, "9: 1.5 +- 0.2 m/s");
  EXPECT_EQ(picture.heading.back(), "2 clusters, 1 dynamic");
  EXPECT_EQ(picture.cube_keys.size(), 1u);
}

TEST(MapPicture, OfManyMovingClustersTheLargestHaveArrows) {
  ldm::LocalMap map = small_map();
  for (int i = 0; i < 30; ++i) {
    map.clusters.push_back({.position = {1.25F, 0.25F, 0.25F},
                            .size = {0.5F, 0.5F, 0.5F},
                            .velocity = {static_cast<float>(i), 0, 0},
                            .voxels = i % 2 == 0 ? 1 : i,
                            .dynamic = true});
  }
  const Picture picture = picture_of(small_frame(), map, std::vector<std::size_t>(30, 0), "");
  ASSERT_EQ(picture.arrows.size(), 12u);
  EXPECT_EQ(picture.arrows.front().label, "0: 29.0 +- 0.0 m/s");
  EXPECT_EQ(picture.arrows.back().label, "0: 7.0 +- 0.0 m/s");
  EXPECT_EQ(picture.arrow_key, "object: velocity of the 12 largest, motion in 1 s");
  EXPECT_EQ(picture.heading.back(), "30 clusters, 30 dynamic");
}

TEST(MapPicture, GreyVoxelsBesideObjectsAreExplained) {
  ldm::LocalMap map = small_map();
  map.labels[0] = 0;
  map.clusters = {{.id = 1,
                   .position = {1.25F, 0.25F, 0.25F},
                   .size = {0.5F, 0.5F, 0.5F},
                   .velocity = {0, 0, 0},
                   .voxels = 1,
                   .dynamic = false}};
  EXPECT_EQ(picture_of(small_frame(), map, {0}, "").cube_keys.size(), 2u);
  map.labels[7] = 0;
  EXPECT_EQ(picture_of(small_frame(), map, {0}, "").cube_keys.size(), 1u);
  map.clusters[0].id = 0;  // followed no more
  const Picture picture = picture_of(small_frame(), map, {0}, "");
  EXPECT_EQ(picture.cubes[0].colour, kNoClusterColour);
  EXPECT_EQ(picture.cube_keys.size(), 2u);
}

}  // namespace
}  // namespace experiments
