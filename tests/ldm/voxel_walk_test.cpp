/// The walk from voxel to voxel against brute force: each voxel is tested against the ray.
#include "ldm/rays.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/ldm/random_inputs.h"
#include "tests/reference/ray_oracle.h"

namespace ldm {
namespace {

/// [voxels] Single precision carries a ray this well from wall to wall.
constexpr double kTolerance = 2e-3;

/// Where each voxel was left, by its linear index.
std::map<std::size_t, float> walked(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                                    float exit, const Eigen::Vector3i& size) {
  VoxelWalk walk(origin, direction, exit, origin.cast<int>(), size);
  BorderAhead border(direction, origin.cast<int>(), size);
  std::map<std::size_t, float> left;
  do {
    EXPECT_TRUE(left.emplace(walk.index(), walk.leaves_at()).second) << "visited twice";
  } while (border.inside_after(walk.step()));
  return left;
}

TEST(VoxelWalkTest, AlongAnAxisByHand) {
  const auto left = walked({0.5F, 2.5F, 2.5F}, {2, 0, 0}, 2.25F, {5, 5, 5});
  ASSERT_EQ(left.size(), 5U);
  for (int x = 0; x < 5; ++x) {
    const std::size_t index = static_cast<std::size_t>(x) + 5 * (2 + 5 * 2);
    ASSERT_EQ(left.count(index), 1U);
    EXPECT_FLOAT_EQ(left.at(index), 0.25F + 0.5F * static_cast<float>(x));
  }
}

// Through an edge of the voxels it takes one step after the other, never both at once.
TEST(VoxelWalkTest, DiagonalsStepAlongOneAxisAtATime) {
  EXPECT_EQ(walked({0.5F, 0.5F, 0.5F}, {1, 1, 1}, 4.5F, {5, 5, 5}).size(), 13U);
  EXPECT_EQ(walked({4.5F, 4.5F, 0.5F}, {-1, -1, 0}, 4.5F, {5, 5, 5}).size(), 9U);
}

TEST(VoxelWalkTest, StandsStillWithoutADirection) {
  VoxelWalk walk(17);
  walk.step();
  EXPECT_EQ(walk.index(), 17U);
}

TEST(VoxelWalkTest, AfterSomeStepsItIsWhereTheyLead) {
  const Eigen::Vector3i size(9, 9, 9);
  const Eigen::Vector3f origin(4.3F, 4.4F, 4.6F);
  for (const Eigen::Vector3f& direction :
       {Eigen::Vector3f(3, -2, 1), Eigen::Vector3f(-0.1F, 0, 2)}) {
    VoxelWalk walk(origin, direction, 1.3F, {4, 4, 4}, size);
    const VoxelWalk begin = walk;
    Eigen::Vector3i steps = Eigen::Vector3i::Zero();
    for (int i = 0; i < 6; ++i) {
      const VoxelWalk::Step step = walk.step();
      steps += Eigen::Vector3i(step.x, step.y, step.z);
      EXPECT_EQ(begin.after(steps).index(), walk.index());
      EXPECT_EQ(begin.after(steps).leaves_at(), walk.leaves_at());
    }
  }
}

TEST(VoxelWalkTest, VisitsTheVoxelsThatTheRayCrosses) {
  Random random(11);
  for (const Eigen::Vector3i& size : map_sizes()) {
    const VoxelBox box{VoxelIndex::Zero(), size};
    for (int trial = 0; trial < 40; ++trial) {
      Eigen::Vector3f origin;
      Eigen::Vector3f direction;
      for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = static_cast<float>(uniform(0.05, 0.95, random) * size[axis]);
        direction[axis] = static_cast<float>(uniform(-1, 1, random));
      }
      // Almost along an axis, or far from unit length.
      if (trial % 4 == 1) direction[trial % 3] *= 1e-6F;
      if (trial % 4 == 2) direction *= 1e4F;
      reference::Ray ray{origin.cast<double>(), direction.cast<double>(), 0, 1e12};
      ray.end = reference::passage(ray, {0, 0, 0}, size.cast<double>())->leave;
      const auto left = walked(origin, direction, static_cast<float>(ray.end), size);
      for_each_voxel(box, [&](const VoxelIndex& v, std::size_t i) {
        const auto crossing = reference::crossing(ray, v, kTolerance);
        if (crossing == reference::Crossing::kGrazed) return;
        const auto visited = left.find(i);
        ASSERT_EQ(visited != left.end(), crossing == reference::Crossing::kCrossed)
            << v.transpose() << " of " << size.transpose() << ", trial " << trial;
        if (visited == left.end()) return;
        const double voxels = std::abs(visited->second - reference::passage(ray, v)->leave) *
                              direction.cast<double>().norm();
        ASSERT_LT(voxels, kTolerance);
      });
    }
  }
}

}  // namespace
}  // namespace ldm
