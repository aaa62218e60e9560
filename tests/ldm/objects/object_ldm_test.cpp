#include "ldm/objects/object_ldm.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ldm/local_dynamic_map.h"
#include "tests/ldm/box_scans.h"

namespace ldm {
namespace {

Parameters parameters() {
  Parameters p;
  p.particles.count = 20000;
  p.prediction.sub_voxel = SubVoxelMotion::kTrilinear;
  p.prediction.min_speed = 0.1;
  p.sensor_model.log_odds_max = 1;
  return p;
}

/// A post that crosses the map along y at that speed [m/s], before a wall.
std::vector<Box> scene(double time, double speed) {
  return {{{1.5, -2.2 + speed * time, 0.1}, {0.2, 0.2, 1}}, {{2.3, 0, 0.1}, {0.1, 4.5, 1}}};
}

/// Share of the voxels hit by a scan on the post that are occupied after it, from the fourth on.
template <class M>
double hits_occupied(M& mapper, double speed, double rate, int frames) {
  int hit = 0, occupied = 0;
  LocalMap map;
  for (int i = 0; i < frames; ++i) {
    const double time = i / rate;
    const Scan scan = scan_of(scene(time, speed), time, {0.075, 0.075, 0.075});
    mapper.update(scan);
    mapper.read(map);
    if (i < 4) continue;
    for (const Point& p : scan.points) {
      const Eigen::Vector3d world = scan.T_world_sensor * p.cast<double>();
      const VoxelIndex v = voxel_at(world, map.resolution);
      if (world.x() > 1.7 || !map.window.contains(v)) continue;
      ++hit;
      occupied += map.occupancy[map.window.index(v)] > 0.5F ? 1 : 0;
    }
  }
  return static_cast<double>(occupied) / hit;
}

/// A free voxel stands at the lower clamp of -2, and a hit adds 0.85: what is gone after one or two
/// never shows, at any sensor model of the paper's kind.
TEST(ObjectLdm, HoldsWhatIsTooFastForLogOdds) {
  for (const double speed : {3.0, 4.5}) {  // two and three voxels a scan
    const int frames = static_cast<int>(4.2 / speed * 10);
    LocalDynamicMap paper(parameters());
    EXPECT_LT(hits_occupied(paper, speed, 10, frames), 0.4) << speed;
    ObjectLdm ours(parameters());
    EXPECT_GT(hits_occupied(ours, speed, 10, frames), 0.95) << speed;
  }
}

TEST(ObjectLdm, ClustersHaveTheVelocityOfTheirObject) {
  ObjectLdm mapper(parameters());
  for (int i = 0; i < 20; ++i) {
    mapper.update(scan_of(scene(0.1 * i, 1.2), 0.1 * i, {0.075, 0.075, 0.075}));
  }
  LocalMap map;
  mapper.read(map);
  int moving = 0;
  for (const Cluster& cluster : map.clusters) {
    if (cluster.dynamic) {
      ++moving;
      EXPECT_NEAR(cluster.velocity.y(), 1.2, 0.1);
      EXPECT_NEAR(cluster.velocity.x(), 0, 0.1);
    } else if (cluster.voxels > 20) {
      EXPECT_LT(cluster.velocity.norm(), 0.02);
    }
  }
  EXPECT_EQ(moving, 1);
}

/// A post hides the middle of a box: its ends are one cluster, as they are one object.
TEST(ObjectLdm, PiecesOfAnObjectAreOneCluster) {
  ObjectLdm mapper(parameters());
  LocalMap map;
  for (int i = 0; i < 20; ++i) {
    const std::vector<Box> boxes{{{1.8, 0, 0.1}, {0.2, 1.2, 1}},
                                 {{1, 1 - 0.05 * i, 0.1}, {0.15, 0.15, 1.4}}};
    mapper.update(scan_of(boxes, 0.1 * i, {0.075, 0.075, 0.075}));
  }
  mapper.read(map);
  std::vector<std::int64_t> ids;
  for (const Cluster& cluster : map.clusters) {
    if (cluster.id != 0) ids.push_back(cluster.id);
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 2}));
}

/// The map moves an object while nothing is seen of it.
TEST(ObjectLdm, MovesWhatIsHidden) {
  Parameters p = parameters();
  p.prediction.sub_voxel = SubVoxelMotion::kResidual;  // shares out no probabilities: lasts longer
  ObjectLdm mapper(p);
  LocalMap map;
  std::vector<double> places;
  for (int i = 0; i < 20; ++i) {
    Scan scan = scan_of(scene(0.1 * i, 1.2), 0.1 * i, {0.075, 0.075, 0.075});
    if (i >= 17) {
      scan.points.clear();
      scan.no_returns.clear();
    }
    mapper.update(scan);
    mapper.read(map);
    for (const Cluster& c : map.clusters) {
      if (i >= 16 && c.velocity.norm() > 0.6F) places.push_back(c.position.y());
    }
  }
  ASSERT_EQ(places.size(), 4u);
  EXPECT_NEAR(places.back() - places.front(), 0.36, 0.15);
}

TEST(ObjectLdm, RefusesWhatEveryMapperRefuses) {
  Parameters p = parameters();
  p.map.resolution = 0;
  EXPECT_THROW(ObjectLdm{p}, InvalidInput);
  ObjectLdm mapper(parameters());
  Scan scan;
  scan.time = 1;
  mapper.update(scan);
  scan.time = 0;
  EXPECT_THROW(mapper.update(scan), InvalidInput);
}

}  // namespace
}  // namespace ldm
