#include "tests/reference/dense_grid.h"

#include <gtest/gtest.h>

namespace reference {
namespace {

TEST(DenseGrid, WindowIsCentredOnItsVoxel) {
  DenseGrid<int> grid({5, 5, 6});
  grid.recenter({10, -10, 0});
  EXPECT_EQ(grid.window().origin, ldm::VoxelIndex(8, -12, -3));
}

TEST(DenseGrid, CellsStayWhileTheirVoxelDoes) {
  DenseGrid<int> grid({5, 5, 5}, 7);
  EXPECT_EQ(grid.at({1, 1, 1}), 7);
  grid.at({1, 1, 1}) = 3;
  grid.recenter({2, 2, 2});
  EXPECT_EQ(grid.at({1, 1, 1}), 3);
}

TEST(DenseGrid, CellsThatLeftAreForgotten) {
  DenseGrid<int> grid({5, 5, 5}, 7);
  grid.at({-2, 0, 0}) = 3;
  grid.recenter({1, 0, 0});
  grid.recenter({0, 0, 0});
  EXPECT_EQ(grid.at({-2, 0, 0}), 7);
}

}  // namespace
}  // namespace reference
