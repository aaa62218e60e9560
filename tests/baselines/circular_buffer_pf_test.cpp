#include "baselines/circular_buffer_pf.h"

#include <gtest/gtest.h>

#include "tests/reference/scan_of_boxes.h"

namespace baselines {
namespace {

/// A box drives by at 1 m/s while the UAV flies beside it at 0.5 m/s; another box stands.
ldm::Scan drive_by(int frame) {
  const double x = -0.97 + 0.1 * frame;
  return reference::scan_of_boxes(
      0.1 * frame, {0.02 + 0.05 * frame, 0.03, 0.01},
      {{{x, 1.27, -0.4}, {x + 0.5, 1.72, 0.4}}, {{0.47, -1.92, -0.4}, {1.02, -1.55, 0.4}}}, 128);
}

ldm::Parameters filter_parameters() {
  ldm::Parameters parameters;
  parameters.particles.count = 20000;
  parameters.particles.sigma_xy = 0.35;
  parameters.particles.sigma_z = 0.35;
  parameters.clusters.readjust = false;
  return parameters;
}

TEST(CircularBufferPf, ItsMapIsTheCircularBuffers) {
  CircularBufferPf filtered(filter_parameters());
  CircularBuffer plain(filter_parameters());
  ldm::LocalMap filtered_map;
  ldm::LocalMap plain_map;
  for (int k = 0; k < 10; ++k) {
    filtered.update(drive_by(k));
    plain.update(drive_by(k));
    filtered.read(filtered_map);
    plain.read(plain_map);
    EXPECT_EQ(filtered_map.window.origin, plain_map.window.origin);
    EXPECT_EQ(filtered_map.occupancy, plain_map.occupancy);
  }
}

TEST(CircularBufferPf, FindsWhatMovesAndWhatStands) {
  CircularBufferPf filtered(filter_parameters());
  ldm::LocalMap map;
  for (int k = 0; k < 25; ++k) filtered.update(drive_by(k));
  filtered.read(map);
  ASSERT_EQ(map.clusters.size(), 2U);
  const ldm::Cluster& standing = map.clusters[0];  // y < 0: the first in window order
  const ldm::Cluster& moving = map.clusters[1];
  EXPECT_LT(standing.position.y(), 0);
  EXPECT_LT(standing.velocity.norm(), 0.2F);
  EXPECT_FALSE(standing.dynamic);
  EXPECT_GT(moving.velocity.x(), 0.4F);
  EXPECT_TRUE(moving.dynamic);
  EXPECT_EQ(map.labels[map.window.index(ldm::voxel_at(standing.position.cast<double>(), 0.15))], 0);
}

TEST(CircularBufferPf, SameSeedSameVelocities) {
  CircularBufferPf one(filter_parameters());
  CircularBufferPf two(filter_parameters());
  ldm::LocalMap map_one;
  ldm::LocalMap map_two;
  for (int k = 0; k < 5; ++k) {
    one.update(drive_by(k));
    two.update(drive_by(k));
  }
  one.read(map_one);
  two.read(map_two);
  ASSERT_EQ(map_one.clusters.size(), map_two.clusters.size());
  for (std::size_t c = 0; c < map_one.clusters.size(); ++c) {
    EXPECT_EQ(map_one.clusters[c].velocity, map_two.clusters[c].velocity);
  }
}

TEST(CircularBufferPf, GoesOnAfterAJumpThatLosesAllParticles) {
  CircularBufferPf filtered(filter_parameters());
  filtered.update(drive_by(0));
  filtered.update(reference::scan_at(0.1, {50, 50, 50}));
  ldm::Scan scan = reference::scan_at(0.2, {50, 50, 50});
  scan.points = {{1, 0, 0}};
  filtered.update(scan);
  ldm::LocalMap map;
  filtered.read(map);
  ASSERT_EQ(map.clusters.size(), 1U);
  EXPECT_NE(map.clusters[0].velocity, ldm::Velocity::Zero());  // it has particles
}

}  // namespace
}  // namespace baselines
