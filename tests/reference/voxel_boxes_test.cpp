#include "tests/reference/voxel_boxes.h"

#include <gtest/gtest.h>

namespace reference {
namespace {

TEST(VoxelBoxes, VoxelsComeInTheOrderOfTheirIndex) {
  const ldm::VoxelBox box{{-1, 4, 7}, {2, 3, 5}};
  std::size_t expected = 0;
  for_each_voxel(box, [&](const ldm::VoxelIndex& v) {
    EXPECT_TRUE(box.contains(v));
    EXPECT_EQ(box.index(v), expected);
    EXPECT_EQ(voxel_of(box, expected), v);
    ++expected;
  });
  EXPECT_EQ(expected, 30U);
}

}  // namespace
}  // namespace reference
