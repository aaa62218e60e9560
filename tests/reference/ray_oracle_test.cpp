#include "tests/reference/ray_oracle.h"

#include <gtest/gtest.h>

namespace reference {
namespace {

TEST(RayOracle, PassageOfAnAxisParallelRay) {
  const Ray ray{{0.5, 0.5, 0.5}, {1, 0, 0}, 0, 10};
  const auto through = passage(ray, ldm::VoxelIndex(3, 0, 0));
  ASSERT_TRUE(through);
  EXPECT_DOUBLE_EQ(through->enter, 2.5);
  EXPECT_DOUBLE_EQ(through->leave, 3.5);
  EXPECT_FALSE(passage(ray, ldm::VoxelIndex(3, 1, 0)));
  EXPECT_FALSE(passage(ray, ldm::VoxelIndex(-1, 0, 0)));
  EXPECT_FALSE(passage(ray, ldm::VoxelIndex(11, 0, 0)));
}

TEST(RayOracle, PassageOfASlantedRay) {
  const Ray ray{{0, 0.25, 0.5}, {2, 1, 0}, 0, 5};  // y = 0.25 + x / 2
  EXPECT_TRUE(passage(ray, ldm::VoxelIndex(1, 0, 0)));
  EXPECT_TRUE(passage(ray, ldm::VoxelIndex(1, 1, 0)));
  EXPECT_FALSE(passage(ray, ldm::VoxelIndex(0, 1, 0)));
  EXPECT_FALSE(passage(ray, ldm::VoxelIndex(2, 0, 0)));
  EXPECT_DOUBLE_EQ(passage(ray, ldm::VoxelIndex(1, 1, 0))->enter, 0.75);
}

TEST(RayOracle, RaysThroughAnEdgeGraze) {
  const Ray ray{{0.5, 0.5, 0.5}, {1, 1, 0}, 0, 3};
  EXPECT_EQ(crossing(ray, {1, 1, 0}), Crossing::kCrossed);
  EXPECT_EQ(crossing(ray, {1, 0, 0}), Crossing::kGrazed);
  EXPECT_EQ(crossing(ray, {0, 1, 0}), Crossing::kGrazed);
  EXPECT_EQ(crossing(ray, {2, 0, 0}), Crossing::kMissed);
}

TEST(RayOracle, ARayEndsInACentreAndGoesOnBehindIt) {
  const Eigen::Vector3d sensor(0.5, 0.5, 0.5);
  EXPECT_EQ(crossing(ray_to_centre(sensor, {4, 0, 0}), {4, 0, 0}), Crossing::kCrossed);
  EXPECT_EQ(crossing(ray_to_centre(sensor, {4, 0, 0}), {5, 0, 0}), Crossing::kMissed);
  EXPECT_EQ(crossing(ray_behind(sensor, {4, 0, 0}), {5, 0, 0}), Crossing::kCrossed);
  EXPECT_EQ(crossing(ray_behind(sensor, {4, 0, 0}), {3, 0, 0}), Crossing::kMissed);
}

}  // namespace
}  // namespace reference
