#include "tests/reference/plain_ldm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ldm/local_dynamic_map.h"
#include "tests/reference/scan_of_boxes.h"

namespace reference {
namespace {

ldm::Parameters small_parameters() {
  ldm::Parameters parameters;
  parameters.particles.count = 20000;
  return parameters;
}

ldm::LocalMap map_of(const ldm::Mapper& mapper) {
  ldm::LocalMap map;
  mapper.read(map);
  return map;
}

float probability_of(const ldm::LocalMap& map, const ldm::VoxelIndex& v) {
  return map.occupancy[map.window.index(v)];
}

/// A scan from the centre of voxel 0, as long as one ray along x.
ldm::Scan one_ray(double time, float range) {
  ldm::Scan scan = scan_at(time, {0.075, 0.075, 0.075});
  scan.points = {{range, 0, 0}};
  return scan;
}

TEST(PlainLdm, OneHitByHand) {
  PlainLdm plain(small_parameters());
  plain.update(one_ray(0, 0.9F));
  const ldm::LocalMap map = map_of(plain);
  EXPECT_FLOAT_EQ(probability_of(map, {6, 0, 0}), 0.7F);
  EXPECT_FLOAT_EQ(probability_of(map, {5, 0, 0}), 0.4F);
  EXPECT_FLOAT_EQ(probability_of(map, {7, 0, 0}), 0.5F);
  EXPECT_FLOAT_EQ(probability_of(map, {6, 1, 0}), 0.5F);
  ASSERT_EQ(map.clusters.size(), 1U);
  EXPECT_EQ(map.clusters[0].voxels, 1);
  EXPECT_TRUE(map.clusters[0].position.isApprox(ldm::Point(0.975F, 0.075F, 0.075F)));
  EXPECT_TRUE(map.clusters[0].size.isApprox(ldm::Point::Constant(0.15F)));
  EXPECT_EQ(map.labels[map.window.index({6, 0, 0})], 0);
  EXPECT_EQ(map.labels[map.window.index({5, 0, 0})], -1);
}

TEST(PlainLdm, WhatIsNotSeenFadesByWhereItIs) {
  ldm::Parameters parameters = small_parameters();
  parameters.prediction.sub_voxel = ldm::SubVoxelMotion::kNone;  // nothing moves but by fading
  PlainLdm plain(parameters);
  for (int k = 0; k < 3; ++k) plain.update(one_ray(k, 0.9F));  // voxels 0 to 5 free: 3 * -0.405
  plain.update(one_ray(3, 0.15F));                             // now from voxel 2 on in shadow
  const double l = 3 * std::log(0.4 / 0.6);
  const auto p = [](double log_odds) { return 1 / (1 + std::exp(-log_odds)); };
  const ldm::LocalMap map = map_of(plain);
  EXPECT_NEAR(probability_of(map, {2, 0, 0}), p(l * 0.98), 1e-6);                // 0.075 m behind
  EXPECT_NEAR(probability_of(map, {5, 0, 0}), p(l * 0.98 * 0.3 / 0.525), 1e-6);  // 0.525 m behind
  ldm::Scan nothing = scan_at(4, {0.075, 0.075, 0.075});
  plain.update(nothing);
  EXPECT_NEAR(probability_of(map_of(plain), {2, 0, 0}), p(l * 0.98 * 0.9), 1e-6);
}

TEST(PlainLdm, TheMapFollowsTheUav) {
  PlainLdm plain(small_parameters());
  plain.update(one_ray(0, 0.9F));
  ldm::Scan scan = scan_at(0, {1.575, 0.075, 0.075});
  plain.update(scan);
  ldm::LocalMap map = map_of(plain);
  EXPECT_EQ(map.window.origin, ldm::VoxelIndex(-6, -16, -16));
  EXPECT_LT(probability_of(map, {5, 0, 0}), 0.5F);
  scan.T_world_uav.translation.x() = 1e4;
  plain.update(scan);
  map = map_of(plain);
  for (const float p : map.occupancy) EXPECT_EQ(p, 0.5F);
}

TEST(PlainLdm, RefusesWhatItCannotDo) {
  ldm::Parameters parameters = small_parameters();
  parameters.prediction.sub_voxel = ldm::SubVoxelMotion::kTrilinear;
  EXPECT_THROW(PlainLdm{parameters}, ldm::InvalidInput);
  PlainLdm plain(small_parameters());
  plain.update(one_ray(1, 0.9F));
  EXPECT_THROW(plain.update(one_ray(0.5, 0.9F)), ldm::InvalidInput);
}

/// One box drives by at 1 m/s, another stands. No face lies on a wall between voxels
/// and no ray to a voxel's centre runs through an edge: float and double agree on what is hit.
ldm::Scan drive_by(int frame) {
  const double x = -1.77 + 0.1 * frame;
  return scan_of_boxes(
      0.1 * frame, {0.02137, 0.03071, 0.01193},
      {{{x, 1.27, -0.4}, {x + 0.5, 1.72, 0.4}}, {{-0.33, -1.92, -0.4}, {0.32, -1.55, 0.4}}}, 128);
}

TEST(PlainLdm, OccupancyEqualsTheFastMapsWhereVelocitiesPlayNoPart) {
  ldm::Parameters parameters = small_parameters();
  parameters.prediction.sub_voxel = ldm::SubVoxelMotion::kNone;
  parameters.clusters.static_below = 0;
  parameters.survival.shadow_range = 100;  // the fast map rounds distances in the shadow
  PlainLdm plain(parameters);
  ldm::LocalDynamicMap fast(parameters);
  for (int k = 0; k < 30; ++k) {
    plain.update(drive_by(k));
    fast.update(drive_by(k));
    const ldm::LocalMap expected = map_of(plain);
    const ldm::LocalMap actual = map_of(fast);
    ASSERT_EQ(actual.window.origin, expected.window.origin);
    ASSERT_EQ(actual.labels, expected.labels);
    for (std::size_t i = 0; i < expected.occupancy.size(); ++i) {
      ASSERT_NEAR(actual.occupancy[i], expected.occupancy[i], 1e-5);
    }
  }
}

/// What a mapper makes of the box that drives by: means over the frames once it is known.
struct Score {
  double occupied_voxels = 0;
  double speed_x = 0;
  double speed_across = 0;
};

void add_scores(ldm::Mapper& mapper, Score& score) {
  constexpr int kFrames = 40;
  constexpr int kKnown = 10;
  for (int k = 0; k < kFrames; ++k) {
    mapper.update(drive_by(k));
    if (k < kKnown) continue;
    ldm::Cluster mover;
    for (const ldm::Cluster& cluster : map_of(mapper).clusters) {
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
    ldm::Parameters parameters = small_parameters();
    parameters.execution.seed = static_cast<std::uint64_t>(seed);
    PlainLdm plain(parameters);
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
}  // namespace reference
