/// Where rays end in the map, against the same in double precision.
#include "ldm/measurement_flags.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ldm/random_inputs.h"
#include "tests/reference/ray_oracle.h"

namespace ldm {
namespace {

const Eigen::Vector3f kSensor{2.5F, 2.5F, 2.5F};
const Eigen::Vector3i kSize{5, 5, 5};

VoxelIndex voxel_of(std::size_t index, const Eigen::Vector3i& size) {
  return VoxelBox{VoxelIndex::Zero(), size}.voxel(index);
}

/// The end of one ray; its scale is one voxel a metre.
struct End {
  std::uint8_t flag;
  VoxelIndex voxel;
};
End end_of(const Point& ray, bool for_ever, const Eigen::Vector3f& sensor = kSensor) {
  RayEnds ends(sensor, Eigen::Matrix3f::Identity(), kSize);
  ends.find({&ray, 1}, for_ever);
  return {ends.flag(0), voxel_of(ends.index(0), kSize)};
}

TEST(RayEndsTest, ByHand) {
  const End hit = end_of({1, -2, 0}, false);
  EXPECT_EQ(hit.flag, flag::kOccupied);
  EXPECT_EQ(hit.voxel, VoxelIndex(3, 0, 2));
  const End beyond = end_of({30, 0, 0}, false);
  EXPECT_EQ(beyond.flag, flag::kFree);
  EXPECT_EQ(beyond.voxel, VoxelIndex(4, 2, 2));
  const End without_return = end_of({0, 0, -1}, true);
  EXPECT_EQ(without_return.flag, flag::kFree);
  EXPECT_EQ(without_return.voxel, VoxelIndex(2, 2, 0));
}

TEST(RayEndsTest, ARayWithoutDirectionGoesNowhere) {
  EXPECT_EQ(end_of({0, 0, 0}, true).flag, flag::kNone);
  EXPECT_EQ(end_of({0, 0, 0}, false).flag, flag::kOccupied);  // a return at the sensor itself
}

// A wall is as near as numbers can be: 1/t is large, infinite or, along the wall, not a number.
TEST(RayEndsTest, BesideAWall) {
  const Eigen::Vector3f low = Eigen::Vector3f::Constant(std::nextafter(0.0F, 1.0F));
  const Eigen::Vector3f high = Eigen::Vector3f::Constant(std::nextafter(5.0F, 0.0F));
  for (const bool for_ever : {false, true}) {
    EXPECT_EQ(end_of({9, 0, 0}, for_ever, low).flag, flag::kFree);
    EXPECT_EQ(end_of({9, 0, 0}, for_ever, low).voxel, VoxelIndex(4, 0, 0));
    EXPECT_EQ(end_of({-9, 0, 0}, for_ever, low).voxel, VoxelIndex(0, 0, 0));
    EXPECT_EQ(end_of({0, 9, 0}, for_ever, high).flag, flag::kFree);
    EXPECT_EQ(end_of({0, 9, 0}, for_ever, high).voxel, VoxelIndex(4, 4, 4));
    EXPECT_EQ(end_of({0, 0, -9}, for_ever, high).voxel, VoxelIndex(4, 4, 0));
  }
  EXPECT_EQ(end_of({2.5, 0, 0}, false, low).flag, flag::kOccupied);
  EXPECT_EQ(end_of({2.5, 0, 0}, false, low).voxel, VoxelIndex(2, 0, 0));
  EXPECT_EQ(end_of({0, -2.5, 0}, false, high).voxel, VoxelIndex(4, 2, 4));
}

TEST(RayEndsTest, AsInDoublePrecisionForAnyNumberOfRays) {
  Random random(4);
  const Eigen::Vector3i size(33, 12, 7);
  const Eigen::Vector3f sensor(10.3F, 5.1F, 2.2F);
  Eigen::Matrix3f turn;
  turn << 0.36F, 0.48F, -0.8F, -0.8F, 0.6F, 0, 0.48F, 0.64F, 0.6F;
  turn *= 6.5F;
  RayEnds ends(sensor, turn, size);
  int hits = 0;
  for (std::size_t n = 0; n <= RayEnds::kMost; ++n) {
    const bool for_ever = n % 3 == 0;
    std::vector<Point> rays(n);
    for (Point& ray : rays) ray = random_vector(-3000, 3000, random).cast<float>() / 1500;
    ends.find(rays, for_ever);
    for (std::size_t i = 0; i < n; ++i) {
      const reference::Ray ray{sensor.cast<double>(), (turn * rays[i]).cast<double>(), 0, 1e9};
      const double leave = reference::passage(ray, {0, 0, 0}, size.cast<double>())->leave;
      const bool hit = !for_ever && leave > 1;
      hits += hit ? 1 : 0;
      ASSERT_EQ(ends.flag(i), hit ? flag::kOccupied : flag::kFree);
      const Eigen::Vector3d end = ray.origin + std::min(leave, hit ? 1.0 : leave) * ray.direction;
      // The voxel's nearest point lies at the end, but for rounding.
      const Eigen::Array3d low = voxel_of(ends.index(i), size).cast<double>();
      ASSERT_TRUE((end.array() > low - 1e-3).all() && (end.array() < low + 1.001).all());
    }
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace ldm
