#include "tests/reference/components_oracle.h"

#include <gtest/gtest.h>

namespace reference {
namespace {

TEST(ComponentsOracle, VoxelsThatShareACornerAreNeighbours) {
  EXPECT_TRUE(are_neighbours({0, 0, 0}, {1, -1, 1}));
  EXPECT_FALSE(are_neighbours({0, 0, 0}, {2, 0, 0}));
}

TEST(ComponentsOracle, NumbersComponentsByTheirFirstVoxel) {
  const std::vector<ldm::VoxelIndex> voxels = {{0, 0, 0}, {5, 5, 5}, {2, 2, 2},
                                               {1, 1, 1}, {6, 5, 4}, {9, 9, 9}};
  EXPECT_EQ(components(voxels), (std::vector<int>{0, 1, 0, 0, 1, 2}));
}

TEST(ComponentsOracle, NoVoxelsNoComponents) {
  EXPECT_TRUE(components({}).empty());
}

}  // namespace
}  // namespace reference
