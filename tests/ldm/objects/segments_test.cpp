#include "ldm/objects/segments.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace ldm {
namespace {

std::vector<std::vector<std::size_t>> found(Segments& segments,
                                            const std::vector<Eigen::Vector3d>& points) {
  segments.find(points);
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t s = 0; s < segments.count(); ++s) {
    all.emplace_back(segments.members(s).begin(), segments.members(s).end());
  }
  return all;
}

TEST(Segments, AreNoneOfNothing) {
  Segments segments(0.2);
  EXPECT_TRUE(found(segments, {}).empty());
}

TEST(Segments, LinkTouchingCellsAndOneEmptyBetweenTwoRings) {
  Segments segments(1);
  const std::vector<std::vector<std::size_t>> expected = {{0, 2, 4}, {1}, {3}};
  EXPECT_EQ(found(segments, {{0.5, 0.5, 0.5},      // cell 0 0 0
                             {2.5, 0.5, 0.5},      // cell 2 0 0: a cell is free between
                             {1.5 - 2, 1.5, 0.5},  // cell -1 1 0: touches at an edge
                             {0.5, 0.5, 3.5},      // cell 0 0 3: two are free between
                             {0.5, 0.5, -1.5}}),   // cell 0 0 -2: one is free between
            expected);
}

TEST(Segments, ReachAsFarAsTheyAreTold) {
  Segments segments(1, {1, 1, 1});
  const std::vector<std::vector<std::size_t>> expected = {{0, 1}, {2}};
  EXPECT_EQ(found(segments, {{0.5, 0.5, 0.5}, {1.5, 1.5, -0.5}, {0.5, 0.5, 2.5}}), expected);
}

/// Components by brute force: all pairs of points.
TEST(Segments, AreTheComponentsOfTouchingCells) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  std::vector<Eigen::Vector3d> points(150);
  for (Eigen::Vector3d& p : points) p = {place(random), place(random), place(random)};
  const double edge = 0.2;
  std::vector<std::size_t> component(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) component[i] = i;
  for (std::size_t pass = 0; pass < points.size(); ++pass) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        const VoxelIndex d = voxel_at(points[i], edge) - voxel_at(points[j], edge);
        const bool touch = std::abs(d.x()) <= 1 && std::abs(d.y()) <= 1 && std::abs(d.z()) <= 2;
        if (touch) component[i] = component[j] = std::min(component[i], component[j]);
      }
    }
  }
  std::set<std::vector<std::size_t>> expected;
  for (std::size_t c = 0; c < points.size(); ++c) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (component[i] == c) members.push_back(i);
    }
    if (!members.empty()) expected.insert(members);
  }
  Segments segments(edge);
  const auto result = found(segments, points);
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(std::set(result.begin(), result.end()), expected);
}

}  // namespace
}  // namespace ldm
