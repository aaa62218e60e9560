#include "baselines/octomap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "baselines/liboctomap.h"
#include "tests/ldm/random_inputs.h"
#include "tests/reference/scan_of_boxes.h"

namespace baselines {
namespace {

class OctomapTest : public testing::Test {
 protected:
  /// A scan from voxel 0 or, for the window alone, from `uav` [m].
  void see(float range, const Eigen::Vector3d& uav = {0.075, 0.075, 0.075}) {
    ldm::Scan scan = reference::scan_at(time_++, uav);
    scan.points = {{range, 0, 0}};
    octomap_.update(scan);
  }
  /// Log-odds of voxel (x, 0, 0).
  double log_odds(int x) {
    octomap_.read(map_);
    const double p = map_.occupancy[map_.window.index({x, 0, 0})];
    return std::log(p / (1 - p));
  }

  Octomap octomap_{ldm::Parameters()};
  ldm::LocalMap map_;
  double time_ = 0;
};

constexpr double kHit = 0.847297860387203;    // log(0.7 / 0.3)
constexpr double kMiss = -0.405465108108164;  // log(0.4 / 0.6)

TEST_F(OctomapTest, HitsAndMissesAddUpWithinTheClamps) {
  for (int k = 1; k <= 6; ++k) {
    see(0.6F);
    EXPECT_NEAR(log_odds(4), std::min(kHit * k, 3.5), 1e-5);
    EXPECT_NEAR(log_odds(2), std::max(kMiss * k, -2.0), 1e-5);
  }
  see(0.9F);
  EXPECT_NEAR(log_odds(4), 3.5 + kMiss, 1e-5);
}

TEST_F(OctomapTest, RaysEndAtHalfTheDiagonalOfTheMap) {
  see(90);  // 0.5 * sqrt(3) * 4.8 m = 4.157 m: the ray ends in voxel 28
  octomap_.update(reference::scan_at(time_, {4.2, 0, 0}));
  EXPECT_NEAR(log_odds(27), kMiss, 1e-5);
  EXPECT_NEAR(log_odds(28), 0, 1e-5);
  see(4.1F);  // a return within the limit is a hit although it lies outside the window
  octomap_.update(reference::scan_at(time_, {4.2, 0, 0}));
  EXPECT_NEAR(log_odds(27), kMiss + kHit, 1e-5);
}

TEST_F(OctomapTest, RemembersWhatTheWindowHasLeft) {
  see(0.6F);
  octomap_.update(reference::scan_at(time_, {30, 0, 0}));
  octomap_.read(map_);
  EXPECT_EQ(map_.occupancy, std::vector<float>(map_.window.count(), 0.5F));
  octomap_.update(reference::scan_at(time_, {0, 0, 0}));
  EXPECT_NEAR(log_odds(4), kHit, 1e-5);
}

TEST_F(OctomapTest, IsWhatInsertPointCloudMakesOfTheSameScans) {
  LibOctomap library{ldm::Parameters()};
  ldm::LocalMap expected;
  ldm::Random random(5);
  Eigen::Vector3d uav = Eigen::Vector3d::Zero();
  for (int k = 0; k < 30; ++k) {
    for (int axis = 0; axis < 3; ++axis) uav[axis] += ldm::uniform(-0.1, 0.1, random);
    // A box that comes and goes, one beyond the window, and a wall beyond the range limit.
    const Eigen::Vector3d corner(1, -0.5, -0.5 + (k + 1) % 3);
    const std::vector<reference::Box> boxes = {{corner, corner + Eigen::Vector3d(0.4, 1, 1)},
                                               {{-4, -1, -1}, {-3, 1, 1}},
                                               {{-9, 5, -2}, {9, 6, 2}}};
    const ldm::Scan scan = reference::scan_of_boxes(time_++, uav, boxes, 128);
    octomap_.update(scan);
    library.update(scan);
    octomap_.read(map_);
    library.read(expected);
    ASSERT_EQ(map_.window.origin, expected.window.origin);
    ASSERT_EQ(map_.occupancy, expected.occupancy) << "scan " << k;
  }
  const auto [lowest, highest] = std::minmax_element(map_.occupancy.begin(), map_.occupancy.end());
  EXPECT_LT(*lowest, 0.2F);
  EXPECT_GT(*highest, 0.6F);
}

/// Its square is less than any number of 32 bits, so the ray has no direction.
TEST_F(OctomapTest, TheShortestRayAcrossAWallArrives) {
  ldm::Scan scan = reference::scan_at(time_++, {0, 0, 0});
  scan.points = {{-1e-30F, -1e-30F, 0}};
  octomap_.update(scan);
  EXPECT_NEAR(log_odds(0), kMiss, 1e-5);
  const double p = map_.occupancy[map_.window.index({-1, -1, 0})];
  EXPECT_NEAR(std::log(p / (1 - p)), kHit, 1e-5);
}

TEST_F(OctomapTest, RefusesAUavOutOfTheTree) {
  see(0.6F);
  EXPECT_NO_THROW(octomap_.update(reference::scan_at(time_, {4900, 0, 0})));
  EXPECT_THROW(octomap_.update(reference::scan_at(time_, {0, -4915, 0})), ldm::InvalidInput);
  ldm::Scan scan = reference::scan_at(time_, {0, 0, 0});
  scan.T_world_sensor.translation.z() = 5000;
  EXPECT_THROW(octomap_.update(scan), ldm::InvalidInput);
}

}  // namespace
}  // namespace baselines
