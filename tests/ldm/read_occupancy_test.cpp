#include "ldm/read_occupancy.h"

#include <gtest/gtest.h>

#include "ldm/log_odds.h"
#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

TEST(ReadOccupancyTest, WindowOrderFromAnyPlaceInTheRing) {
  Random random(1);
  LocalMap map;
  for (const Eigen::Vector3i& n : map_sizes()) {
    RingBuffer<float> log_odds(n);
    for (float& l : log_odds.cells()) {
      l = uniform_int(0, 2, random) == 0 ? 0.0F : static_cast<float>(uniform(-2, 3.5, random));
    }
    log_odds.recenter(random_vector(-40, 40, random));
    for (int i = 0; i < 50; ++i) {
      log_odds.at(random_voxel(log_odds.index().window(), random)) = 3.5F;
    }
    read_occupancy(log_odds, 0.25, map);

    EXPECT_EQ(map.window.origin, log_odds.index().window().origin);
    EXPECT_EQ(map.window.size, n);
    EXPECT_EQ(map.resolution, 0.25);
    ASSERT_EQ(map.occupancy.size(), log_odds.cells().size());
    for_each_voxel(map.window, [&](const VoxelIndex& v, std::size_t i) {
      const auto expected = static_cast<float>(probability(log_odds.at(v)));
      ASSERT_EQ(map.occupancy[i], expected) << v.transpose();
    });
  }
}

TEST(ReadOccupancyTest, UnknownIsExactlyOneHalf) {
  RingBuffer<float> log_odds({5, 5, 5});
  log_odds.at({0, 0, 0}) = 3.5F;
  LocalMap map;
  read_occupancy(log_odds, 0.15, map);
  for (std::size_t i = 0; i < map.occupancy.size(); ++i) {
    if (i == map.window.index({0, 0, 0})) {
      EXPECT_NEAR(map.occupancy[i], 0.970688, 1e-6);
    } else {
      EXPECT_EQ(map.occupancy[i], 0.5F);
    }
  }
}

TEST(ReadOccupancyTest, PointsAreCountedInTheVoxelsOfTheirCluster) {
  LocalMap map;
  map.window = {{0, 0, 0}, {3, 1, 1}};
  map.resolution = 1;
  map.labels = {0, 0, -1};
  map.clusters.resize(2);
  map.clusters[1].points = 5;  // of a scan before
  Scan scan;
  scan.T_world_sensor.translation << 1, 0, 0;
  scan.points = {{-0.5F, 0.5F, 0.5F},  // three in the first cluster, in two voxels
                 {-0.6F, 0.5F, 0.5F},
                 {0.5F, 0.5F, 0.5F},
                 {1.5F, 0.5F, 0.5F},  // in a voxel of none
                 {5, 0.5F, 0.5F}};    // out of the map
  count_points(scan, map);
  EXPECT_EQ(map.clusters[0].points, 3);
  EXPECT_EQ(map.clusters[1].points, 0);
}

}  // namespace
}  // namespace ldm
