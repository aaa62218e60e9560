#include "experiments/avoidance/planner/distance_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "datasets/random.h"

namespace experiments {
namespace {

constexpr double kEdge = 0.15;

/// What `DistanceField::distances` should hold, voxel by voxel against all others.
std::vector<float> brute_force(const ldm::VoxelBox& window,
                               const std::vector<std::uint8_t>& occupied, double reach) {
  std::vector<float> distances(window.count());
  for (std::size_t i = 0; i < window.count(); ++i) {
    double nearest = reach;
    for (std::size_t j = 0; j < window.count(); ++j) {
      if (occupied[j] == 0) continue;
      nearest =
          std::min(nearest, kEdge * (window.voxel(i) - window.voxel(j)).cast<double>().norm());
    }
    distances[i] = static_cast<float>(nearest);
  }
  return distances;
}

TEST(DistanceField, EqualsBruteForce) {
  const ldm::VoxelBox window{{-3, 7, 1}, {11, 9, 6}};
  for (const double share : {0.003, 0.02, 0.3, 1.0}) {
    datasets::Random random(5);
    for (int round = 0; round < 20; ++round) {
      std::vector<std::uint8_t> occupied(window.count());
      for (auto& is_occupied : occupied) is_occupied = random.uniform(0, 1) < share ? 1 : 0;
      DistanceField field(1.0);
      field.build(window, kEdge, occupied);
      const std::vector<float> expected = brute_force(window, occupied, 1.0);
      for (std::size_t i = 0; i < window.count(); ++i) {
        ASSERT_NEAR(field.distances()[i], expected[i], 1e-6) << "voxel " << i;
      }
    }
  }
}

TEST(DistanceField, IsTheReachWhereNothingIsOccupied) {
  const ldm::VoxelBox window{{0, 0, 0}, {5, 5, 5}};
  DistanceField field(0.8);
  field.build(window, kEdge, std::vector<std::uint8_t>(window.count()));
  for (const float distance : field.distances()) EXPECT_FLOAT_EQ(distance, 0.8F);
}

/// A wall at x in [0, 0.15): from its centres at x = 0.075 the distance grows along x alone.
TEST(DistanceField, GrowsEvenlyFromAWall) {
  const ldm::VoxelBox window{{0, 0, 0}, {12, 6, 6}};
  std::vector<std::uint8_t> occupied(window.count());
  for (std::size_t i = 0; i < window.count(); ++i) occupied[i] = window.voxel(i).x() == 0 ? 1 : 0;
  DistanceField field(5);
  field.build(window, kEdge, occupied);
  for (const double x : {0.075, 0.3, 0.5, 1.6}) {
    const Distance distance = field.at({x, 0.41, 0.37});
    EXPECT_NEAR(distance.value, x - 0.075, 1e-6);
    EXPECT_NEAR((distance.gradient - Eigen::Vector3d::UnitX()).norm(), 0, 1e-5);
  }
}

TEST(DistanceField, TakesTheUnknownForFree) {
  const ldm::VoxelBox window{{0, 0, 0}, {5, 5, 5}};
  DistanceField field(0.8);
  field.build(window, kEdge, std::vector<std::uint8_t>(window.count(), 1));
  EXPECT_NEAR(field.at({0.3, 0.3, 0.3}).value, 0, 1e-9);
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.05, 0.3, 0.3), Eigen::Vector3d(0.3, 0.7, 0.3),
                                   Eigen::Vector3d(0.3, 0.3, -9)}) {
    EXPECT_EQ(field.at(p).value, 0.8);
    EXPECT_EQ(field.at(p).gradient.norm(), 0);
  }
}

TEST(DistanceField, HasTheGradientOfItsValue) {
  const ldm::VoxelBox window{{-5, -5, -5}, {10, 10, 10}};
  datasets::Random random(3);
  std::vector<std::uint8_t> occupied(window.count());
  for (auto& is_occupied : occupied) is_occupied = random.uniform(0, 1) < 0.02 ? 1 : 0;
  DistanceField field(5);
  field.build(window, kEdge, occupied);
  constexpr double kStep = 1e-4;
  for (int i = 0; i < 200; ++i) {
    // Well inside a cell of the interpolation, so that no difference crosses a kink.
    Eigen::Vector3d p;
    for (double& along : p)
      along = (std::floor(random.uniform(-4, 4)) + random.uniform(0.6, 1.4)) * kEdge;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      const double slope = (field.at(p + step).value - field.at(p - step).value) / (2 * kStep);
      EXPECT_NEAR(field.at(p).gradient[axis], slope, 1e-4);
    }
  }
}

}  // namespace
}  // namespace experiments
