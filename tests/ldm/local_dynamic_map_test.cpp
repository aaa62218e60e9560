#include "ldm/local_dynamic_map.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/ldm/box_scans.h"

namespace ldm {
namespace {

Parameters small_filter() {
  Parameters parameters;
  parameters.particles.count = 20000;
  return parameters;
}

LocalMap read(const LocalDynamicMap& map) {
  LocalMap local;
  map.read(local);
  return local;
}

/// The cluster nearest to x.
Cluster cluster_at(const LocalMap& map, const Eigen::Vector3d& x) {
  const auto distance = [&](const Cluster& c) { return (c.position.cast<double>() - x).norm(); };
  const auto nearest = std::min_element(
      map.clusters.begin(), map.clusters.end(),
      [&](const Cluster& a, const Cluster& b) { return distance(a) < distance(b); });
  if (nearest == map.clusters.end()) return {};
  return *nearest;
}

TEST(LocalDynamicMapTest, OneHitByHand) {
  LocalDynamicMap map(small_filter());
  Scan scan;
  scan.T_world_uav.translation = scan.T_world_sensor.translation = {0.075, 0.075, 0.075};
  scan.points = {{0.45F, 0, 0}};  // three voxels ahead
  map.update(scan);
  const LocalMap local = read(map);
  const auto at = [&](int x, int y, int z) {
    return local.occupancy[local.window.index({x, y, z})];
  };
  EXPECT_EQ(local.window.origin, VoxelIndex(-16, -16, -16));
  EXPECT_EQ(local.window.size, Eigen::Vector3i(32, 32, 32));
  EXPECT_EQ(local.resolution, 0.15);
  EXPECT_NEAR(at(3, 0, 0), 0.7, 1e-6);
  for (int x = 0; x < 3; ++x) EXPECT_NEAR(at(x, 0, 0), 0.4, 1e-6);
  EXPECT_EQ(at(4, 0, 0), 0.5F);
  EXPECT_EQ(at(0, 1, 0), 0.5F);
  ASSERT_EQ(local.clusters.size(), 1u);
  EXPECT_EQ(local.clusters[0].voxels, 1);
  EXPECT_TRUE(local.clusters[0].position.isApprox(Point(0.525F, 0.075F, 0.075F)));
  EXPECT_EQ(local.labels[local.window.index({3, 0, 0})], 0);
  EXPECT_EQ(std::count(local.labels.begin(), local.labels.end(), -1), 32 * 32 * 32 - 1);
}

/// The cluster of a box that moves along y, averaged from 2 s to 4 s.
struct SeenMotion {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  double distance = 0;  ///< from the box's centre [m]
  int dynamic = 0;      ///< frames of 20

  SeenMotion(double y, double speed) {
    LocalDynamicMap map(Parameters{});
    for (int k = 0; k < 40; ++k) {
      const double t = 0.1 * k;
      const Box box{{1.4, y + speed * t, 1}, {0.5, 0.5, 0.9}};
      map.update(scan_of({box}, t, {0, 0, 1}));
      if (k < 20) continue;
      const Cluster cluster = cluster_at(read(map), box.centre);
      velocity += cluster.velocity.cast<double>() / 20;
      distance += (cluster.position.cast<double>() - box.centre).norm() / 20;
      dynamic += cluster.dynamic ? 1 : 0;
    }
  }
};

TEST(LocalDynamicMapTest, StandingBoxBecomesAStaticCluster) {
  const SeenMotion seen(0.2, 0);
  EXPECT_LT(seen.velocity.norm(), 0.1) << seen.velocity.transpose();
  EXPECT_LT(seen.distance, 0.4);  // only its front is seen
  EXPECT_LE(seen.dynamic, 5);
}

TEST(LocalDynamicMapTest, MovingBoxGetsItsVelocity) {
  const SeenMotion seen(-1, 0.5);
  EXPECT_NEAR(seen.velocity.y(), 0.5, 0.15);
  // Behind an obstacle unseen occupancy survives: clusters drift away from the sensor.
  EXPECT_LT((seen.velocity - Eigen::Vector3d(0, 0.5, 0)).norm(), 0.2) << seen.velocity.transpose();
  EXPECT_LT(seen.distance, 0.4);
  EXPECT_GE(seen.dynamic, 17);  // of 20, from 2 s after it came into view
}

TEST(LocalDynamicMapTest, ScansWithoutAnyPointLeaveAllUnknown) {
  LocalDynamicMap map(small_filter());
  for (int k = 0; k < 10; ++k) {
    Scan scan;
    scan.time = 0.1 * k;
    scan.T_world_uav.translation = {0.1 * k, -0.2 * k, 0};
    map.update(scan);
  }
  const LocalMap local = read(map);
  EXPECT_EQ(local.occupancy, std::vector<float>(32 * 32 * 32, 0.5F));
  EXPECT_TRUE(local.clusters.empty());
  EXPECT_EQ(local.window.origin, voxel_at({0.9, -1.8, 0}, 0.15) - VoxelIndex(16, 16, 16));
  for (const Particle& p : map.particles().all()) {
    const Eigen::Vector3d x = map.particles().position(p, map.log_odds().index());
    ASSERT_TRUE(local.window.contains(voxel_at(x, 0.15)));
  }
}

/// The free voxel (2, 0, 0) goes unseen; the static object at (3, 0, 0) stays as it is.
TEST(LocalDynamicMapTest, EmptyScanMovesAndAgesTheMap) {
  Parameters parameters = small_filter();
  parameters.clusters.static_below = 100;  // whatever the particles say
  parameters.prediction.sub_voxel = SubVoxelMotion::kNone;
  LocalDynamicMap map(parameters);
  Scan scan;
  scan.T_world_uav.translation = scan.T_world_sensor.translation = {0.075, 0.075, 0.075};
  scan.points = {{0.45F, 0, 0}};
  map.update(scan);
  Scan empty;
  empty.time = 0.1;
  empty.T_world_uav.translation = {0.4, -0.1, 0.2};
  map.update(empty);
  EXPECT_EQ(map.log_odds().index().centre(), VoxelIndex(2, -1, 1));
  EXPECT_NEAR(map.log_odds().at({3, 0, 0}), 0.847298, 1e-5);
  EXPECT_NEAR(map.log_odds().at({2, 0, 0}), -0.405465 * 0.9, 1e-5);
}

TEST(LocalDynamicMapTest, UavThatJumpsFindsAFreshMap) {
  LocalDynamicMap map(small_filter());
  for (int k = 0; k < 3; ++k) {
    map.update(scan_of({{{1.2, 0, 0}, {0.5, 0.5, 0.5}}}, 0.1 * k, {0, 0, 0}));
  }
  ASSERT_FALSE(read(map).clusters.empty());
  Scan scan;
  scan.time = 0.3;
  scan.T_world_uav.translation = {-1000, 4.9, 2000};
  map.update(scan);
  const LocalMap local = read(map);
  EXPECT_TRUE(local.window.contains(voxel_at({-1000, 4.9, 2000}, 0.15)));
  EXPECT_EQ(local.occupancy, std::vector<float>(32 * 32 * 32, 0.5F));
  EXPECT_TRUE(local.clusters.empty());
  for (const Particle& p : map.particles().all()) {
    ASSERT_LT(p.slot, map.log_odds().index().count());
  }
}

TEST(LocalDynamicMapTest, ParticlesThatTheMapLeavesBehindAreGone) {
  Parameters parameters = small_filter();
  parameters.particles.birth = false;
  LocalDynamicMap map(parameters);
  map.update(Scan{});
  Scan moved;
  moved.T_world_uav.translation = {1.6, 0, 0};  // 10 voxels on, at the same time
  map.update(moved);
  const RingIndex& index = map.log_odds().index();
  ASSERT_EQ(index.window().origin, VoxelIndex(-6, -16, -16));
  for (const Particle& p : map.particles().all()) {
    ASSERT_LT(map.particles().position(p, index).x(), 16 * 0.15);  // where the map ended before
  }
}

TEST(LocalDynamicMapTest, StagesInTheOrderOfFigure1) {
  struct Listener final : StageListener {
    void begin(std::string_view stage) override { stages.emplace_back(stage); }
    std::vector<std::string> stages;
  } listener;
  LocalDynamicMap map(small_filter());
  map.update(Scan{}, &listener);
  EXPECT_EQ(listener.stages,
            (std::vector<std::string>{"occupancy_prediction", "particle_prediction",
                                      "movement_update", "measurement_flags", "occupancy_update",
                                      "particle_update", "resampling", "clustering"}));
}

TEST(LocalDynamicMapTest, RefusesBadParameters) {
  Parameters parameters;
  parameters.sensor_model.p_occ = 0.4;
  try {
    LocalDynamicMap map(parameters);
    FAIL() << "p_occ = 0.4 was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "sensor_model.p_occ = 0.4: allowed: a number from 0.501 to 0.999");
  }
}

}  // namespace
}  // namespace ldm
