#include "baselines/octomap_file.h"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace baselines {
namespace {

std::filesystem::path some_file() {
  return std::filesystem::temp_directory_path() / ("ldm_" + std::to_string(getpid()) + ".bt");
}

/// 8 x 6 x 10 voxels of 0.2 m away from the origin: occupied, free and unknown ones in turn, and a
/// block of free ones that the tree joins to one leaf.
ldm::LocalMap some_map() {
  ldm::LocalMap map;
  map.window = {{-4, 100, -6}, {8, 6, 10}};
  map.resolution = 0.2;
  constexpr float kStates[] = {0.9F, 0.5F, 0.1F, 0.51F, 0.49F};
  for (std::size_t i = 0; i < map.window.count(); ++i) map.occupancy.push_back(kStates[i % 5]);
  for (int z = -4; z < 0; ++z) {
    for (int y = 100; y < 104; ++y) {
      for (int x = -4; x < 0; ++x) map.occupancy[map.window.index({x, y, z})] = 0.2F;
    }
  }
  return map;
}

TEST(OctomapFile, ReadsBackAsTheSameOccupiedAndFreeVoxels) {
  const ldm::LocalMap map = some_map();
  const std::filesystem::path file = some_file();
  std::ofstream stream(file, std::ios::binary);
  write_bt(map, "origin_m 1 2 3", stream);
  stream.close();
  octomap::OcTree tree(file.string());
  std::filesystem::remove(file);

  EXPECT_DOUBLE_EQ(tree.getResolution(), 0.2);
  std::size_t known = 0;
  // One voxel more on every side, where the tree must know nothing.
  const ldm::VoxelIndex end = map.window.origin + map.window.size;
  for (int z = -7; z <= end.z(); ++z) {
    for (int y = 99; y <= end.y(); ++y) {
      for (int x = -5; x <= end.x(); ++x) {
        const Eigen::Vector3d centre = 0.2 * (Eigen::Vector3d(x, y, z).array() + 0.5);
        const octomap::OcTreeNode* node = tree.search(centre.x(), centre.y(), centre.z());
        const bool inside = map.window.contains({x, y, z});
        const float p = inside ? map.occupancy[map.window.index({x, y, z})] : 0.5F;
        ASSERT_EQ(node != nullptr, p != 0.5F) << x << ' ' << y << ' ' << z;
        if (node == nullptr) continue;
        ++known;
        EXPECT_EQ(tree.isNodeOccupied(node), p > 0.5F) << x << ' ' << y << ' ' << z;
      }
    }
  }
  EXPECT_LT(tree.getNumLeafNodes(), known);  // the block became fewer leaves
}

TEST(OctomapFile, RefusesWhatTheTreeCannotHold) {
  ldm::LocalMap map = some_map();
  map.window.origin.x() = 32761;
  std::ostringstream stream;
  EXPECT_THROW(write_bt(map, "", stream), ldm::InvalidInput);
}

}  // namespace
}  // namespace baselines
