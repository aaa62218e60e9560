/// The order of voxels in a box.
#include "ldm/types.h"

#include <gtest/gtest.h>

namespace ldm {
namespace {

TEST(VoxelBoxTest, PositionsRunAlongXThenYThenZAndBack) {
  const VoxelBox box{{-3, 40, 5}, {5, 7, 6}};
  std::size_t index = 0;
  for (int z = 5; z < 11; ++z) {
    for (int y = 40; y < 47; ++y) {
      for (int x = -3; x < 2; ++x, ++index) {
        ASSERT_EQ(box.index({x, y, z}), index);
        ASSERT_EQ(box.voxel(index), VoxelIndex(x, y, z));
      }
    }
  }
  EXPECT_EQ(index, box.count());
}

}  // namespace
}  // namespace ldm
