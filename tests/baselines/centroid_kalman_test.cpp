#include "baselines/centroid_kalman.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/scan_of_boxes.h"

namespace baselines {
namespace {

const Eigen::Vector3d kSensor(0.075, 0.075, 1.075);

/// 125 points, 0.2 m apart.
void add_cloud(double x, double y, ldm::Scan& scan) {
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      for (int k = 0; k < 5; ++k) {
        const Eigen::Vector3d p(x - 0.4 + 0.2 * i, y - 0.4 + 0.2 * j, 0.6 + 0.2 * k);
        scan.points.push_back((p - kSensor).cast<float>());
      }
    }
  }
}

class CentroidKalmanTest : public testing::Test {
 protected:
  CentroidKalmanTest() : mapper_(parameters()) {}
  static ldm::Parameters parameters() {
    ldm::Parameters parameters;
    parameters.map.voxels = {96, 96, 32};
    return parameters;
  }
  const std::vector<ldm::Cluster>& see(const ldm::Scan& scan) {
    mapper_.update(scan);
    mapper_.read(map_);
    return map_.clusters;
  }

  CentroidKalman mapper_;
  ldm::LocalMap map_;
};

/// The same clouds and numbers as in tests/yardstick/test_constant_velocity.py.
TEST_F(CentroidKalmanTest, VelocitiesAreThoseOfTheYardstickInPython) {
  for (int k = 0; k < 10; ++k) {
    ldm::Scan scan = reference::scan_at(0.1 * k, kSensor);
    add_cloud(-3 + 0.5 * k, 2 + 0.05 * k * k, scan);
    if (k >= 3) add_cloud(0, -3 + 0.01 * k, scan);
    see(scan);
  }
  ASSERT_EQ(map_.clusters.size(), 2u);
  const ldm::Cluster& fast = map_.clusters[map_.clusters[0].id == 1 ? 0 : 1];
  const ldm::Cluster& slow = map_.clusters[map_.clusters[0].id == 1 ? 1 : 0];
  EXPECT_EQ(fast.id, 1);
  EXPECT_EQ(slow.id, 2);
  EXPECT_NEAR(fast.velocity.x(), 5.00073, 1e-4);
  EXPECT_NEAR(fast.velocity.y(), 6.7015, 1e-4);
  EXPECT_NEAR(slow.velocity.x(), 0, 1e-4);
  EXPECT_NEAR(slow.velocity.y(), 0.10002, 1e-4);
  EXPECT_NEAR(fast.velocity_covariance(0, 0), 0.19235, 1e-5);
  EXPECT_NEAR(fast.age, 0.9, 1e-9);
  EXPECT_TRUE(fast.dynamic);
  EXPECT_FALSE(slow.dynamic) << "0.1 m/s, and clusters.static_below_mps is 0.2";
}

TEST_F(CentroidKalmanTest, ClustersAreVoxelsWithTheirReturns) {
  ldm::Scan scan = reference::scan_at(0, kSensor);
  add_cloud(2, 0, scan);
  scan.points.emplace_back(-2.0F, 0.0F, 0.0F);  // a single return is none
  ASSERT_EQ(see(scan).size(), 1u);
  EXPECT_NEAR(map_.clusters[0].position.x(), 2, 0.08);
  EXPECT_NEAR(map_.clusters[0].size.x(), 0.9, 0.16);
  EXPECT_GE(map_.clusters[0].voxels, 100);  // of 125; a layer lies on the border of voxels
  EXPECT_EQ(std::count(map_.labels.begin(), map_.labels.end(), 0), map_.clusters[0].voxels);
}

TEST_F(CentroidKalmanTest, WhatIsUnseenForMoreThanHalfASecondIsForgotten) {
  for (const double time : {0.0, 0.1, 0.2, 0.7, 1.3, 1.4}) {
    ldm::Scan scan = reference::scan_at(time, kSensor);
    if (time != 1.3) add_cloud(2, 0, scan);
    const std::vector<ldm::Cluster>& clusters = see(scan);
    if (time == 1.3) continue;
    EXPECT_EQ(clusters.at(0).id, time < 1.3 ? 1 : 2) << time;
  }
}

}  // namespace
}  // namespace baselines
