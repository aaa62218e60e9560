#include "experiments/avoidance/sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace experiments {
namespace {

constexpr double kEdge = 0.1;

/// A window from the origin on, 40 x 20 x 10 voxels: a cluster that stands in voxels x = 5, and one
/// of 2 x 1 x 3 voxels from (20, 10, 4) on that moves at 1 m/s along y.
class TwoClusters final : public ldm::Mapper {
 public:
  static inline Eigen::Matrix2f covariance;  ///< of the velocity of the one that moves

  explicit TwoClusters(const ldm::Parameters&) {}
  void update(const ldm::Scan&, ldm::StageListener*) override {}
  void read(ldm::LocalMap& map) const override {
    map.window = {{0, 0, 0}, {40, 20, 10}};
    map.resolution = kEdge;
    map.occupancy.assign(map.window.count(), 0.5F);
    map.labels.assign(map.window.count(), -1);
    map.clusters.resize(2);
    map.clusters[0].velocity = {0.1F, 0, 0};
    map.clusters[1].velocity = {0, 1, 0};
    map.clusters[1].velocity_covariance = covariance;
    for (std::size_t i = 0; i < map.window.count(); ++i) {
      const ldm::VoxelIndex v = map.window.voxel(i);
      const bool moves = (v.array() >= Eigen::Array3i(20, 10, 4)).all() &&
                         (v.array() < Eigen::Array3i(22, 11, 7)).all();
      if (!moves && v.x() != 5) continue;
      map.occupancy[i] = 0.9F;
      map.labels[i] = moves ? 1 : 0;
    }
  }
};

std::unique_ptr<Sight> sight_of_two_clusters(
    const Trust& trust, const Eigen::Matrix2f& covariance = Eigen::Matrix2f::Zero()) {
  TwoClusters::covariance = covariance;
  static const Method kMethod{.name = "two_clusters",
                              .help = "",
                              .finds_clusters = true,
                              .parameters = {},
                              .create = ldm::create<TwoClusters>};
  auto sight = mapped_sight(kMethod, {}, trust);
  sight->see({});
  return sight;
}

TEST(MappedSight, TakesWhatMovesOutOfTheFieldAndPredictsItsBox) {
  Surroundings around;
  sight_of_two_clusters({.margin = 0, .doubt = 1, .moving_from = 0.3})->predict({0, 2}, around);
  ASSERT_EQ(around.movers.size(), 1U);
  const Mover& mover = around.movers[0];
  EXPECT_NEAR((mover.half_size - Eigen::Vector3d(0.1, 0.05, 0.15)).norm(), 0, 1e-9);
  EXPECT_NEAR((mover.centre[0] - Eigen::Vector3d(2.1, 1.05, 0.55)).norm(), 0, 1e-6);
  EXPECT_NEAR((mover.centre[1] - Eigen::Vector3d(2.1, 3.05, 0.55)).norm(), 0, 1e-6);
  EXPECT_NEAR(mover.doubt[0], 0.1, 1e-9);
  EXPECT_NEAR(mover.doubt[1], std::hypot(0.1, 0.15 * 2), 1e-9);
  // Where the mover is now, nothing stands nearer than the wall: 2.05 - 0.55 m, at most the reach.
  EXPECT_NEAR(around.from_still({1.55, 1.05, 0.55}).value, 1.0, 1e-5);
  EXPECT_NEAR(around.from_still({2.05, 1.05, 0.55}).value, 1.5, 1e-5);
}

/// Of [[0.05, 0.03], [0.03, 0.13]] the eigenvalues are 0.14 and 0.04.
TEST(MappedSight, WidensWhatMovesByTheCovarianceOfItsVelocity) {
  Surroundings around;
  Eigen::Matrix2f covariance;
  covariance << 0.05F, 0.03F, 0.03F, 0.13F;
  const auto sight = sight_of_two_clusters({.margin = 0, .doubt = 2}, covariance);
  sight->predict({0, 0.5, 30}, around);
  const std::vector<double>& doubt = around.movers.at(0).doubt;
  EXPECT_NEAR(doubt[0], 2 * 0.1, 1e-6);
  EXPECT_NEAR(doubt[1], 2 * std::hypot(0.1, std::sqrt(0.14) * 0.5), 1e-6);
  EXPECT_EQ(doubt[2], 0.8) << "at most";
}

TEST(MappedSight, LetsEverythingStandBelowTheSpeed) {
  Surroundings around;
  sight_of_two_clusters({.margin = 0.1, .doubt = 1, .moving_from = 2})->predict({0}, around);
  EXPECT_TRUE(around.movers.empty());
  EXPECT_NEAR(around.from_still({2.05, 1.05, 0.55}).value, 0 - 0.1, 1e-5);
}

TEST(MappedSight, KnowsAnObjectByAVoxelInItsBox) {
  const auto sight = sight_of_two_clusters({});
  datasets::ObjectState object;
  object.size = {0.3, 0.3, 0.3};
  object.position = {2.1, 1.05, 0.55};
  EXPECT_TRUE(sight->knows(object));
  object.position = {3, 1, 0.5};
  EXPECT_FALSE(sight->knows(object));
  object.position = {-50, 1, 0.5};
  EXPECT_FALSE(sight->knows(object)) << "beyond the window";
}

/// A cylinder that goes 2 m along x at 1 m/s and then back, and one that stands.
std::vector<datasets::Obstacle> turning_and_standing() {
  datasets::ObstacleBody body;
  body.solids.push_back({datasets::Solid::Shape::kCylinder, {}, {0.4, 0.4, 2}});
  body.radius = 0.2;
  body.height = 2;
  const datasets::Leg there{.start = 0,
                            .from = {0, 0},
                            .direction = {1, 0},
                            .length = 2,
                            .top_speed = 1,
                            .acceleration = 100,
                            .pause = 0};
  datasets::Leg back = there;
  back.start = there.travel_time();
  back.from = {2, 0};
  back.direction = {-1, 0};
  return {{0, body, 0, datasets::ObstacleMotion({there, back})},
          {1, body, 0, datasets::ObstacleMotion({0, 1.5}, 0)}};
}

Surroundings seen_by_oracle(bool future) {
  const std::vector<datasets::Obstacle> obstacles = turning_and_standing();
  datasets::Frame frame;
  frame.scan.time = 1;
  frame.scan.T_world_uav.translation = {0, 0, 1};
  frame.truth.emplace();
  frame.truth->objects.resize(2);
  for (std::size_t i = 0; i < 2; ++i) obstacles[i].state_at(1, frame.truth->objects[i]);
  ldm::Parameters parameters;
  const auto sight = true_sight(parameters, obstacles, future, {.margin = 0, .doubt = 0});
  sight->see(frame);
  Surroundings around;
  sight->predict({0, 2}, around);
  return around;
}

TEST(TrueSight, LetsWhatMovesGoOn) {
  const Surroundings around = seen_by_oracle(false);
  ASSERT_EQ(around.movers.size(), 1U);
  EXPECT_NEAR(around.movers[0].centre[0].x(), 1, 0.02);
  EXPECT_NEAR(around.movers[0].centre[1].x(), 3, 0.02);
  EXPECT_EQ(around.movers[0].doubt[1], 0);
  EXPECT_NEAR(around.from_still({0, 1.0, 1}).value, 0.3, 0.15) << "within a voxel";
}

/// The window of the default parameters is 4.8 m wide: both are in it, one cannot be 5 m away.
TEST(TrueSight, DrawsWhatItKnowsAsAMap) {
  std::vector<datasets::Obstacle> obstacles = turning_and_standing();
  obstacles.push_back({2, obstacles[1].body, 0, datasets::ObstacleMotion({0, 5}, 0)});
  datasets::Frame frame;
  frame.scan.T_world_uav.translation = {0, 0, 1};
  frame.truth.emplace();
  frame.truth->objects.resize(3);
  for (std::size_t i = 0; i < 3; ++i) obstacles[i].state_at(1, frame.truth->objects[i]);
  const auto sight = true_sight({}, obstacles, false, {});
  sight->see(frame);
  const ldm::LocalMap map = sight->map();
  ASSERT_EQ(map.clusters.size(), 2U);
  EXPECT_TRUE(map.clusters[0].dynamic);
  EXPECT_NEAR(map.clusters[0].velocity.x(), 1, 1e-3);
  EXPECT_FALSE(map.clusters[1].dynamic);
  const std::size_t inside = map.window.index(ldm::voxel_at({0, 1.5, 1}, map.resolution));
  EXPECT_EQ(map.labels[inside], 1);
  EXPECT_TRUE(ldm::is_occupied(map.occupancy[inside]));
  const auto solid = std::count(map.labels.begin(), map.labels.end(), 1);
  EXPECT_EQ(map.clusters[1].voxels, solid);
  EXPECT_EQ(map.labels[map.window.index(ldm::voxel_at({0, -1, 1}, map.resolution))], -1);
}

TEST(TrueSight, OfTheFutureKnowsThatItTurns) {
  EXPECT_NEAR(seen_by_oracle(true).movers.at(0).centre[1].x(), 1, 0.05);
}

}  // namespace
}  // namespace experiments
