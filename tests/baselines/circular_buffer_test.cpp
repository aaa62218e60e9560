#include "baselines/circular_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/reference/dense_grid.h"
#include "tests/reference/scan_of_boxes.h"

namespace baselines {
namespace {

constexpr double kHit = 0.847297860387203;    // log(0.7 / 0.3)
constexpr double kMiss = -0.405465108108164;  // log(0.4 / 0.6)

ldm::Scan one_return(double time, float range) {
  ldm::Scan scan = reference::scan_at(time, {0.075, 0.075, 0.075});
  scan.points = {{range, 0, 0}};
  return scan;
}

TEST(CircularBuffer, HitsAndMissesAddUpWithinTheClamps) {
  CircularBuffer buffer{ldm::Parameters()};
  for (int k = 1; k <= 6; ++k) {
    buffer.update(one_return(k, 0.6F));
    EXPECT_NEAR(buffer.log_odds().at({4, 0, 0}), std::min(kHit * k, 3.5), 1e-5);
    EXPECT_NEAR(buffer.log_odds().at({2, 0, 0}), std::max(kMiss * k, -2.0), 1e-5);
  }
  buffer.update(one_return(7, 0.9F));
  EXPECT_NEAR(buffer.log_odds().at({4, 0, 0}), 3.5 + kMiss, 1e-5);
}

TEST(CircularBuffer, WhatIsNotSeenKeepsItsValue) {
  CircularBuffer buffer{ldm::Parameters()};
  buffer.update(one_return(0, 0.6F));
  for (int k = 1; k <= 100; ++k) buffer.update(reference::scan_at(k, {0.075, 0.075, 0.075}));
  EXPECT_NEAR(buffer.log_odds().at({4, 0, 0}), kHit, 1e-6);
  EXPECT_NEAR(buffer.log_odds().at({2, 0, 0}), kMiss, 1e-6);
}

TEST(CircularBuffer, WhatLeavesTheWindowIsForgotten) {
  CircularBuffer buffer{ldm::Parameters()};
  buffer.update(one_return(0, 0.6F));
  buffer.update(reference::scan_at(1, {0.15 * 20 + 0.075, 0, 0}));  // lowest voxel: 20 - 16 = 4
  EXPECT_NEAR(buffer.log_odds().at({4, 0, 0}), kHit, 1e-6);
  buffer.update(reference::scan_at(2, {0.15 * 21 + 0.075, 0, 0}));
  buffer.update(reference::scan_at(3, {0.15 * 20 + 0.075, 0, 0}));
  EXPECT_EQ(buffer.log_odds().at({4, 0, 0}), 0);
}

/// [11] by brute force, in doubles. A voxel in which rounding once decided is in doubt.
class DenseMap {
 public:
  struct Cell {
    double log_odds = 0;
    bool in_doubt = false;
  };

  explicit DenseMap(const ldm::Parameters& parameters)
      : resolution_(parameters.map.resolution), cells_(parameters.map.voxels) {}

  void update(const ldm::Scan& scan) {
    cells_.recenter(ldm::voxel_at(scan.T_world_uav.translation, resolution_));
    const Eigen::Vector3d sensor = scan.T_world_sensor.translation / resolution_;
    std::vector<ldm::VoxelIndex> hits;
    for (const ldm::Point& p : scan.points) {
      hits.push_back(ldm::voxel_at(scan.T_world_sensor * p.cast<double>(), resolution_));
    }
    for_each_voxel(cells_.window(), [&](const ldm::VoxelIndex& v, std::size_t) {
      auto way = reference::Crossing::kMissed;
      for (const ldm::VoxelIndex& hit : hits) {
        if (hit == v) return add(v, kHit);
        way = std::max(way, reference::crossing(reference::ray_to_centre(sensor, hit), v));
      }
      if (way == reference::Crossing::kGrazed) cells_.at(v).in_doubt = true;
      if (way == reference::Crossing::kCrossed) add(v, kMiss);
    });
  }

  const ldm::VoxelBox& window() const { return cells_.window(); }
  const Cell& at(const ldm::VoxelIndex& v) { return cells_.at(v); }

 private:
  void add(const ldm::VoxelIndex& v, double gain) {
    double& l = cells_.at(v).log_odds;
    l = std::clamp(l + gain, -2.0, 3.5);
  }

  double resolution_;
  reference::DenseGrid<Cell> cells_;
};

TEST(CircularBuffer, EqualsADenseMapOnRandomScans) {
  ldm::Parameters parameters;
  parameters.map.voxels = {9, 12, 7};
  CircularBuffer buffer(parameters);
  DenseMap dense(parameters);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::Vector3d uav(0, 0, 0);
  std::size_t in_doubt = 0;
  for (int k = 0; k < 60; ++k) {
    uav += 0.2 * Eigen::Vector3d(unit(random), unit(random), unit(random));
    ldm::Scan scan = reference::scan_at(k, uav);
    for (int i = 0; i < 12; ++i) {
      const Eigen::Vector3d in_window(0.5 * unit(random), 0.7 * unit(random), 0.3 * unit(random));
      scan.points.push_back(in_window.cast<float>());
    }
    buffer.update(scan);
    dense.update(scan);
    ASSERT_EQ(buffer.log_odds().index().window().origin, dense.window().origin);
    for_each_voxel(dense.window(), [&](const ldm::VoxelIndex& v, std::size_t) {
      const DenseMap::Cell& cell = dense.at(v);
      if (cell.in_doubt) {
        ++in_doubt;
      } else {
        EXPECT_NEAR(buffer.log_odds().at(v), cell.log_odds, 1e-5);
      }
    });
  }
  EXPECT_LT(in_doubt, 60 * dense.window().count() / 100);
}

}  // namespace
}  // namespace baselines
