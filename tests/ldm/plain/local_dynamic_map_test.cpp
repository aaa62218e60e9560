#include "ldm/plain/local_dynamic_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ldm/local_dynamic_map.h"
#include "tests/ldm/plain/drive_by.h"

namespace ldm::plain {
namespace {

using reference::scan_at;

Parameters small_parameters() {
  Parameters parameters;
  parameters.particles.count = 20000;
  parameters.particles.min_per_voxel = 20;
  parameters.particles.sigma_xy = 0.8;  // follows within a few frames
  parameters.prediction.min_speed = 0;
  return parameters;
}

LocalMap map_of(const Mapper& mapper) {
  LocalMap map;
  mapper.read(map);
  return map;
}

float probability_of(const LocalMap& map, const VoxelIndex& v) {
  return map.occupancy[map.window.index(v)];
}

/// A scan from the centre of voxel 0, as long as one ray along x.
Scan one_ray(double time, float range) {
  Scan scan = scan_at(time, {0.075, 0.075, 0.075});
  scan.points = {{range, 0, 0}};
  return scan;
}

TEST(PlainLdm, OneHitByHand) {
  LocalDynamicMap plain(small_parameters());
  plain.update(one_ray(0, 0.9F));
  const LocalMap map = map_of(plain);
  EXPECT_FLOAT_EQ(probability_of(map, {6, 0, 0}), 0.7F);
  EXPECT_FLOAT_EQ(probability_of(map, {5, 0, 0}), 0.4F);
  EXPECT_FLOAT_EQ(probability_of(map, {7, 0, 0}), 0.5F);
  EXPECT_FLOAT_EQ(probability_of(map, {6, 1, 0}), 0.5F);
  ASSERT_EQ(map.clusters.size(), 1U);
  EXPECT_EQ(map.clusters[0].voxels, 1);
  EXPECT_TRUE(map.clusters[0].position.isApprox(Point(0.975F, 0.075F, 0.075F)));
  EXPECT_TRUE(map.clusters[0].size.isApprox(Point::Constant(0.15F)));
  EXPECT_EQ(map.labels[map.window.index({6, 0, 0})], 0);
  EXPECT_EQ(map.labels[map.window.index({5, 0, 0})], -1);
}

TEST(PlainLdm, WhatIsNotSeenFadesByWhereItIs) {
  Parameters parameters = small_parameters();
  parameters.prediction.sub_voxel = SubVoxelMotion::kNone;  // nothing moves but by fading
  LocalDynamicMap plain(parameters);
  for (int k = 0; k < 3; ++k) plain.update(one_ray(k, 0.9F));  // voxels 0 to 5 free: 3 * -0.405
  plain.update(one_ray(3, 0.15F));                             // now from voxel 2 on in shadow
  const double l = 3 * std::log(0.4 / 0.6);
  const auto p = [](double log_odds) { return 1 / (1 + std::exp(-log_odds)); };
  const LocalMap map = map_of(plain);
  EXPECT_NEAR(probability_of(map, {2, 0, 0}), p(l * 0.98), 1e-6);                // 0.075 m behind
  EXPECT_NEAR(probability_of(map, {5, 0, 0}), p(l * 0.98 * 0.3 / 0.525), 1e-6);  // 0.525 m behind
  Scan nothing = scan_at(4, {0.075, 0.075, 0.075});
  plain.update(nothing);
  EXPECT_NEAR(probability_of(map_of(plain), {2, 0, 0}), p(l * 0.98 * 0.9), 1e-6);
}

TEST(PlainLdm, TheMapFollowsTheUav) {
  LocalDynamicMap plain(small_parameters());
  plain.update(one_ray(0, 0.9F));
  Scan scan = scan_at(0, {1.575, 0.075, 0.075});
  plain.update(scan);
  LocalMap map = map_of(plain);
  EXPECT_EQ(map.window.origin, VoxelIndex(-6, -16, -16));
  EXPECT_LT(probability_of(map, {5, 0, 0}), 0.5F);
  scan.T_world_uav.translation.x() = 1e4;
  plain.update(scan);
  map = map_of(plain);
  for (const float p : map.occupancy) EXPECT_EQ(p, 0.5F);
}

TEST(PlainLdm, RefusesWhatItCannotDo) {
  Parameters parameters = small_parameters();
  parameters.prediction.sub_voxel = SubVoxelMotion::kTrilinear;
  EXPECT_THROW(LocalDynamicMap{parameters}, InvalidInput);
  LocalDynamicMap plain(small_parameters());
  plain.update(one_ray(1, 0.9F));
  EXPECT_THROW(plain.update(one_ray(0.5, 0.9F)), InvalidInput);
}

/// What a mapper makes of the box that drives by: means over the frames once it is known.
struct Score {
  double occupied_voxels = 0;
  double speed_x = 0;
  double speed_across = 0;
};

void add_scores(Mapper& mapper, Score& score) {
  constexpr int kFrames = 40;
  constexpr int kKnown = 10;
  for (int k = 0; k < kFrames; ++k) {
    mapper.update(drive_by(k));
    if (k < kKnown) continue;
    Cluster mover;
    for (const Cluster& cluster : map_of(mapper).clusters) {
      score.occupied_voxels += static_cast<double>(cluster.voxels) / (kFrames - kKnown);
      if (cluster.position.y() > 0 && cluster.voxels > mover.voxels) mover = cluster;
    }
    score.speed_x += mover.velocity.x() / (kFrames - kKnown);
    score.speed_across += mover.velocity.tail<2>().norm() / (kFrames - kKnown);
  }
}

TEST(PlainLdm, ScoresAsTheFastMapWithinNoise) {
  constexpr int kSeeds = 5;
  Score expected;
  Score actual;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Parameters parameters = small_parameters();
    parameters.execution.seed = static_cast<std::uint64_t>(seed);
    LocalDynamicMap plain(parameters);
    ldm::LocalDynamicMap fast(parameters);
    add_scores(plain, expected);
    add_scores(fast, actual);
  }
  // Two to three standard errors of the difference over five seeds.
  EXPECT_NEAR(expected.speed_x / kSeeds, 1, 0.2);
  EXPECT_NEAR(actual.speed_x / kSeeds, expected.speed_x / kSeeds, 0.1);
  EXPECT_NEAR(actual.speed_across / kSeeds, expected.speed_across / kSeeds, 0.1);
  EXPECT_NEAR(actual.occupied_voxels / expected.occupied_voxels, 1, 0.2);
}

}  // namespace
}  // namespace ldm::plain
