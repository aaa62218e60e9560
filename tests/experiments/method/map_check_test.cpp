#include "experiments/method/map_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/experiments/metrics/tiny_world.h"
#include "tests/text_file.h"

namespace experiments {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// What is said of a good map with two clusters after `spoil`; empty if nothing is wrong.
std::string said_of(const std::function<void(ldm::LocalMap&)>& spoil) {
  ldm::LocalMap map = unknown_map(3);
  add_cluster(map, {{0, 0, 0}});
  add_cluster(map, {{2, 2, 2}});
  spoil(map);
  return tests::message_of<std::runtime_error>([&] { check_map(map, "mine", 7); });
}

TEST(MapCheck, TakesAGoodMap) {
  ldm::LocalMap map = unknown_map(3);
  add_cluster(map, {{0, 0, 0}, {1, 0, 0}});
  map.occupancy.front() = 0;
  map.occupancy[1] = -0.0F;
  map.occupancy.back() = 1;
  EXPECT_NO_THROW(check_map(map, "mine", 0));
}

TEST(MapCheck, RefusesArraysThatDoNotFitTheWindow) {
  EXPECT_EQ(said_of([](auto& map) { map.occupancy.pop_back(); }),
            "mine, frame 7: length of map.occupancy = 26: allowed: 27, the voxels of the window");
  EXPECT_EQ(said_of([](auto& map) { map.labels.clear(); }),
            "mine, frame 7: length of map.labels = 0: allowed: 27, the voxels of the window");
  EXPECT_EQ(
      said_of([](auto& map) { map.window.size.y() = -3; }),
      "mine, frame 7: map.window.size = (3, -3, 3): allowed: 1 to 4096 voxels along each axis");
  EXPECT_NE(said_of([](auto& map) { map.window.origin.x() = 2147483647; }).find("origin"),
            std::string::npos);
  EXPECT_EQ(said_of([](auto& map) { map.resolution = kNan; }),
            "mine, frame 7: map.resolution = nan: allowed: a number above 0");
}

TEST(MapCheck, RefusesWhatIsNoProbability) {
  for (const float bad : {kNan, -0.001F, 1.001F, std::numeric_limits<float>::infinity()}) {
    const std::string said = said_of([&](auto& map) { map.occupancy[13] = bad; });
    EXPECT_EQ(said.find("mine, frame 7: map.occupancy[13] = "), 0u) << said;
    EXPECT_NE(said.find(": allowed: 0 to 1"), std::string::npos);
  }
}

TEST(MapCheck, RefusesLabelsOfNoCluster) {
  EXPECT_EQ(said_of([](auto& map) { map.labels[5] = 999; }),
            "mine, frame 7: map.labels[5] = 999: allowed: -1 to 1, the positions in map.clusters");
  EXPECT_NE(said_of([](auto& map) { map.labels[5] = 2; }), "");
  EXPECT_NE(said_of([](auto& map) { map.labels[5] = -2; }), "");
  EXPECT_NE(said_of([](auto& map) { map.labels[26] = 2147483647; }), "");
  EXPECT_EQ(said_of([](auto& map) { map.clusters.clear(); }),
            "mine, frame 7: map.labels[0] = 0: allowed: -1: there are no clusters");
}

TEST(MapCheck, RefusesClustersThatAreNotNumbers) {
  EXPECT_EQ(said_of([](auto& map) {
              map.clusters[1].velocity = {0, kNan, 1};
            }),
            "mine, frame 7: map.clusters[1].velocity = (0, nan, 1): allowed: finite numbers");
  EXPECT_NE(said_of([](auto& map) {
              map.clusters[0].position.z() = -1.0F / 0.0F;
            }).find("map.clusters[0].position"),
            std::string::npos);
  EXPECT_EQ(said_of([](auto& map) { map.clusters[1].size.x() = -1; }),
            "mine, frame 7: map.clusters[1].size = (-1, 0, 0): allowed: finite numbers from 0 on");
  EXPECT_EQ(said_of([](auto& map) { map.clusters[0].voxels = -5; }),
            "mine, frame 7: map.clusters[0].voxels = -5: allowed: 0 or more");
  EXPECT_EQ(said_of([](auto& map) { map.clusters[0].id = -1; }),
            "mine, frame 7: map.clusters[0].id = -1: allowed: 0 or more");
  for (const double bad : {-0.1, double{kNan}, 1 / 0.0}) {
    EXPECT_NE(said_of([&](auto& map) { map.clusters[0].age = bad; }).find("map.clusters[0].age"),
              std::string::npos);
  }
}

TEST(MapCheck, RefusesCovariancesThatAreNone) {
  const auto said_of_covariance = [](const Eigen::Matrix2f& covariance) {
    return said_of([&](auto& map) { map.clusters[1].velocity_covariance = covariance; });
  };
  Eigen::Matrix2f covariance;
  covariance << 4, 1, 2, 2;
  EXPECT_EQ(said_of_covariance(covariance),
            "mine, frame 7: map.clusters[1].velocity_covariance = (4, 1, 2): allowed: a symmetric "
            "matrix of finite numbers, variances from 0 on");
  covariance << -1, 0, 0, 2;
  EXPECT_NE(said_of_covariance(covariance), "");
  covariance << 1, 0, 0, kNan;
  EXPECT_NE(said_of_covariance(covariance), "");
}

}  // namespace
}  // namespace experiments
