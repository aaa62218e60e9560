/// The true state of voxels, against every voxel tried one by one.
#include <gtest/gtest.h>

#include "datasets/frame.h"
#include "datasets/solid_bounds.h"
#include "tests/datasets/scenario/random_solids.h"

namespace datasets {
namespace {

constexpr Solid::Shape kShapes[] = {Solid::Shape::kBox, Solid::Shape::kCylinder,
                                    Solid::Shape::kSphere};

Truth random_truth(Random& random) {
  Truth truth;
  for (std::int32_t id = 0; id < 6; ++id) {
    ObjectState& object = truth.objects.emplace_back();
    object.id = id;
    object.solids = {random_solid(kShapes[id % 3], 2, random),
                     random_solid(kShapes[(id + 1) % 3], 2, random)};
  }
  for (int i = 0; i < 200; ++i) {
    truth.noise_free_hits.push_back(random_vector(3, random).cast<float>());
  }
  return truth;
}

TEST(SolidTest, ContainsItsInsideAndItsSurface) {
  const Solid box{Solid::Shape::kBox, {Eigen::Matrix3d::Identity(), {1, 0, 0}}, {2, 4, 6}};
  EXPECT_TRUE(box.contains({2, 2, 3}));
  EXPECT_FALSE(box.contains({2.001, 0, 0}));
  EXPECT_FALSE(box.contains({1, 0, -3.001}));
  const Solid cylinder{
      Solid::Shape::kCylinder, {Eigen::Matrix3d::Identity(), {0, 0, 1}}, {2, 2, 4}};
  EXPECT_TRUE(cylinder.contains({0.6, 0.8, 3}));
  EXPECT_FALSE(cylinder.contains({0.8, 0.8, 1}));
  EXPECT_FALSE(cylinder.contains({0, 0, 3.001}));
  const Solid sphere{Solid::Shape::kSphere, {}, {2, 2, 2}};
  EXPECT_TRUE(sphere.contains({0, 0, 1}));
  EXPECT_FALSE(sphere.contains({0.6, 0.6, 0.6}));
}

TEST(SolidTest, RotationTurnsTheSolid) {
  Eigen::Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Solid box{Solid::Shape::kBox, {quarter, {0, 0, 0}}, {4, 1, 1}};
  EXPECT_TRUE(box.contains({0, 1.9, 0}));
  EXPECT_FALSE(box.contains({1.9, 0, 0}));
  EXPECT_LT((half_extent(box) - Eigen::Vector3d(0.5, 2, 0.5)).norm(), 1e-12);
}

TEST(SolidTest, HalfExtentIsTheSmallestThatHoldsIt) {
  Random random(47);
  for (const Solid::Shape shape : kShapes) {
    const Solid solid = random_solid(shape, 0, random);
    const Eigen::Vector3d half = half_extent(solid);
    Eigen::Vector3d reached = Eigen::Vector3d::Zero();
    for (int i = 0; i < 200000; ++i) {
      const Eigen::Vector3d offset = half.cwiseProduct(random_vector(1.1, random));
      if (solid.contains(solid.T_world_solid.translation + offset)) {
        reached = reached.cwiseMax(offset.cwiseAbs());
      }
    }
    EXPECT_TRUE((reached.array() <= half.array() + 1e-12).all());
    EXPECT_TRUE((reached.array() >= 0.8 * half.array()).all()) << reached << "\n" << half;
  }
}

TEST(TruthTest, SolidVoxelsAgainstEveryVoxel) {
  Random random(53);
  std::vector<std::int32_t> fast;
  std::size_t occupied = 0;
  for (int i = 0; i < 10; ++i) {
    const Truth truth = random_truth(random);
    const ldm::VoxelBox window{{-9 + i, -14, -7}, {18, 24, 15}};
    const double resolution = random.uniform(0.1, 0.3);
    solid_voxels(truth, window, resolution, fast);
    ASSERT_EQ(fast.size(), window.count());
    for (int z = 0; z < 15; ++z) {
      for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 18; ++x) {
          const ldm::VoxelIndex voxel = window.origin + ldm::VoxelIndex(x, y, z);
          const Eigen::Vector3d centre =
              (voxel.cast<double>() + Eigen::Vector3d::Constant(0.5)) * resolution;
          std::int32_t owner = -1;
          for (std::size_t k = truth.objects.size(); k-- > 0;) {
            for (const Solid& solid : truth.objects[k].solids) {
              if (solid.contains(centre)) owner = static_cast<std::int32_t>(k);
            }
          }
          ASSERT_EQ(fast[window.index(voxel)], owner) << voxel.transpose();
          occupied += owner >= 0;
        }
      }
    }
  }
  EXPECT_GT(occupied, 1000u);
}

TEST(TruthTest, VisibleVoxelsAreThoseOfTheHits) {
  Random random(59);
  const Truth truth = random_truth(random);
  const ldm::VoxelBox window{{-10, -10, -10}, {20, 20, 20}};
  std::vector<std::uint8_t> visible(7, 1);
  visible_voxels(truth, window, 0.15, visible);
  ASSERT_EQ(visible.size(), window.count());
  std::vector<std::uint8_t> expected(window.count(), 0);
  for (const ldm::Point& hit : truth.noise_free_hits) {
    const ldm::VoxelIndex voxel(static_cast<int>(std::floor(hit.x() / 0.15)),
                                static_cast<int>(std::floor(hit.y() / 0.15)),
                                static_cast<int>(std::floor(hit.z() / 0.15)));
    if (window.contains(voxel)) expected[window.index(voxel)] = 1;
  }
  EXPECT_EQ(visible, expected);
  EXPECT_GT(std::count(expected.begin(), expected.end(), 1), 5);
}

TEST(TruthTest, AnEmptyTruthIsFreeSpace) {
  const ldm::VoxelBox window{{0, 0, 0}, {5, 5, 5}};
  std::vector<std::int32_t> owners(3, 8);
  solid_voxels({}, window, 0.15, owners);
  EXPECT_EQ(owners, std::vector<std::int32_t>(125, -1));
  std::vector<std::uint8_t> visible(3, 1);
  visible_voxels({}, window, 0.15, visible);
  EXPECT_EQ(visible, std::vector<std::uint8_t>(125, 0));
}

}  // namespace
}  // namespace datasets
