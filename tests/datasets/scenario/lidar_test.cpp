/// The beam pattern and the projection of range images.
#include "datasets/scenario/lidar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace datasets {
namespace {

LidarModel four_by_two() {
  LidarModel model;
  model.elevations = {-std::numbers::pi / 6, 0.25};
  model.azimuths = 4;
  return model;
}

TEST(BeamTableTest, FiringsGoRoundFromBehind) {
  const BeamTable beams(four_by_two());
  const double c = std::cos(std::numbers::pi / 6);
  const Eigen::Vector3d back(-c, 0, -0.5), right(0, -c, -0.5), front(c, 0, -0.5), left(0, c, -0.5);
  EXPECT_LT((beams.direction(0, 0) - back).norm(), 1e-15);
  EXPECT_LT((beams.direction(0, 1) - right).norm(), 1e-15);
  EXPECT_LT((beams.direction(0, 2) - front).norm(), 1e-15);
  EXPECT_LT((beams.direction(0, 3) - left).norm(), 1e-15);
  EXPECT_LT((beams.direction(1, 2) - Eigen::Vector3d(std::cos(0.25), 0, std::sin(0.25))).norm(),
            1e-15);
}

TEST(ProjectTest, SortsRaysIntoReturnsAndNoReturns) {
  RangeImage image{2, 4, {0, 1000, 0, 0, 0, 0, 65535, 1}};
  ldm::Scan scan;
  project(four_by_two(), image, scan);
  ASSERT_EQ(scan.points.size(), 3u);
  ASSERT_EQ(scan.no_returns.size(), 5u);
  const float c = std::cos(std::numbers::pi_v<float> / 6);
  EXPECT_LT((scan.points[0] - ldm::Point(0, -2 * c, -1)).norm(), 1e-6f);
  EXPECT_NEAR(scan.points[1].norm(), 131.07f, 1e-5f);
  EXPECT_NEAR(scan.points[2].norm(), 0.002f, 1e-9f);
  EXPECT_LT((scan.no_returns[0] - ldm::Point(-c, 0, -0.5f)).norm(), 1e-6f);
  for (const ldm::Point& direction : scan.no_returns) EXPECT_NEAR(direction.norm(), 1, 1e-6);
}

TEST(ProjectTest, RepeatedUseOfAScanLeavesNothingBehind) {
  const LidarModel model = four_by_two();
  ldm::Scan scan;
  project(model, {2, 4, {1, 2, 3, 4, 5, 6, 7, 8}}, scan);
  EXPECT_EQ(scan.points.size(), 8u);
  EXPECT_EQ(scan.no_returns.size(), 0u);
  project(model, {2, 4, {0, 0, 0, 0, 0, 0, 0, 9}}, scan);
  EXPECT_EQ(scan.points.size(), 1u);
  EXPECT_EQ(scan.no_returns.size(), 7u);
}

TEST(ProjectTest, RefusesAnImageOfAnotherSize) {
  ldm::Scan scan;
  EXPECT_THROW(project(four_by_two(), {4, 2, std::vector<std::uint16_t>(8)}, scan),
               ldm::InvalidInput);
  EXPECT_THROW(project(four_by_two(), {2, 4, std::vector<std::uint16_t>(7)}, scan),
               ldm::InvalidInput);
}

}  // namespace
}  // namespace datasets
