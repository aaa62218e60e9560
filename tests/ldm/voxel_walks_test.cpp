/// Walks side by side against walks on their own.
#include "ldm/rays.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

const Eigen::Vector3i kSize(33, 12, 20);

VoxelWalk random_walk(Random& random) {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;
  for (int axis = 0; axis < 3; ++axis) {
    origin[axis] = static_cast<float>(uniform(0.05, 0.95, random) * kSize[axis]);
    direction[axis] = static_cast<float>(uniform(-1, 1, random));
  }
  if (uniform_int(0, 3, random) == 0) direction[uniform_int(0, 2, random)] = 0;
  return VoxelWalk(origin, direction, 300, origin.cast<int>(), kSize);
}

TEST(VoxelWalksTest, EachLaneWalksAsIfAlone) {
  Random random(3);
  std::vector<VoxelWalk> alone(VoxelWalks::kLanes, VoxelWalk(0));
  VoxelWalks walks;
  for (int step = 0; step < 2000; ++step) {
    // Now and then another walk begins in some lane.
    if (step % 5 == 0) {
      const int lane = uniform_int(0, VoxelWalks::kLanes - 1, random);
      alone[static_cast<std::size_t>(lane)] = random_walk(random);
      walks.set(lane, alone[static_cast<std::size_t>(lane)]);
    }
    for (int lane = 0; lane < VoxelWalks::kLanes; ++lane) {
      ASSERT_EQ(walks.index(lane), alone[static_cast<std::size_t>(lane)].index())
          << "step " << step;
    }
    walks.step();
    for (VoxelWalk& walk : alone) walk.step();
  }
}

}  // namespace
}  // namespace ldm
