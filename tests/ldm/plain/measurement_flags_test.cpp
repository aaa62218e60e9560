#include "ldm/plain/measurement_flags.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/reference/ray_oracle.h"
#include "tests/reference/scan_of_boxes.h"

namespace ldm::plain {
namespace {

using reference::Crossing;
using reference::crossing;
using reference::scan_at;
using Kind = VoxelFlag::Kind;

constexpr double kResolution = 0.5;
const VoxelBox kWindow{{-4, -4, -4}, {9, 9, 9}};
const Eigen::Vector3d kSensor(0.25, 0.25, 0.25);  // centre of voxel 0

Scan scan_of(const std::vector<Point>& points, const std::vector<Point>& no_returns = {}) {
  Scan scan = scan_at(0, kSensor);
  scan.points = points;
  scan.no_returns = no_returns;
  return scan;
}

/// The flags of voxels x_begin to 4 of the row through the sensor, as letters.
std::string row(const std::vector<VoxelFlag>& flags, int x_begin) {
  std::string letters;
  for (int x = x_begin; x <= 4; ++x) {
    letters += "-SFO"[static_cast<int>(flags[kWindow.index({x, 0, 0})].kind)];
  }
  return letters;
}

TEST(PlainFlags, FreeBeforeAHitAndShadowBehindIt) {
  const auto flags = flag_voxels(scan_of({{1.1F, 0, 0}}), kWindow, kResolution, true);
  EXPECT_EQ(row(flags, -1), "-FFOSS");
  EXPECT_DOUBLE_EQ(flags[kWindow.index({3, 0, 0})].behind, 0.25);
  EXPECT_DOUBLE_EQ(flags[kWindow.index({4, 0, 0})].behind, 0.75);
}

TEST(PlainFlags, OfTwoObstaclesTheNearerThrowsTheShadow) {
  const auto flags = flag_voxels(scan_of({{0.5F, 0, 0}, {1.5F, 0, 0}}), kWindow, kResolution, true);
  EXPECT_EQ(row(flags, -1), "-FOFOS");
  EXPECT_DOUBLE_EQ(flags[kWindow.index({4, 0, 0})].behind, 0.25);
}

TEST(PlainFlags, AHitBeatsACrossing) {
  const auto flags = flag_voxels(scan_of({{1.5F, 0, 0}, {0.5F, 0, 0}}), kWindow, kResolution, true);
  EXPECT_EQ(row(flags, 0), "FOFOS");
}

TEST(PlainFlags, ReturnsBeyondTheMapClearTheWayToTheBorder) {
  EXPECT_EQ(row(flag_voxels(scan_of({{90, 0, 0}}), kWindow, kResolution, false), -1), "-FFFFF");
}

TEST(PlainFlags, RaysWithoutAReturnAreFreeOrDropped) {
  const Scan scan = scan_of({}, {{1, 0, 0}});
  EXPECT_EQ(row(flag_voxels(scan, kWindow, kResolution, true), -1), "-FFFFF");
  EXPECT_EQ(row(flag_voxels(scan, kWindow, kResolution, false), -1), "------");
}

TEST(PlainFlags, ASensorOutsideTheMapSeesIntoIt) {
  Scan scan = scan_of({{5.5F, 0, 0}});
  scan.T_world_sensor.translation.x() = -4.75;
  EXPECT_EQ(row(flag_voxels(scan, kWindow, kResolution, true), -4), "FFFFFOSSS");
  scan.points = {{1.5F, 0, 0}};  // before the map
  EXPECT_EQ(row(flag_voxels(scan, kWindow, kResolution, true), -4), "---------");
}

TEST(PlainFlags, ASensorInTheCentreOfAHitThrowsNoShadow) {
  EXPECT_EQ(row(flag_voxels(scan_of({{0, 0, 0}}), kWindow, kResolution, true), -1), "-O----");
}

/// What brute force says of a voxel, as far as rounding leaves it certain.
struct Verdict {
  bool surely_free = false;
  bool maybe_free = false;
  bool surely_shadow = false;
  bool maybe_shadow = false;
};

std::vector<Verdict> judge(const Eigen::Vector3d& sensor, const std::vector<VoxelIndex>& hits) {
  std::vector<Verdict> verdicts(kWindow.count());
  for (const VoxelIndex& hit : hits) {
    const Ray before = ray_to_centre(sensor / kResolution, hit);
    const Ray behind = reference::ray_behind(sensor / kResolution, hit);
    for_each_voxel(kWindow, [&](const VoxelIndex& v, std::size_t i) {
      if (v == hit) return;
      Verdict& verdict = verdicts[i];
      verdict.surely_free |= crossing(before, v) == Crossing::kCrossed;
      verdict.maybe_free |= crossing(before, v) != Crossing::kMissed;
      verdict.surely_shadow |= crossing(behind, v) == Crossing::kCrossed;
      verdict.maybe_shadow |= crossing(behind, v) != Crossing::kMissed;
    });
  }
  return verdicts;
}

void expect_possible(Kind kind, const Verdict& verdict) {
  EXPECT_TRUE(kind == Kind::kFree ? verdict.maybe_free : !verdict.surely_free);
  if (kind == Kind::kShadow) {
    EXPECT_TRUE(verdict.maybe_shadow);
  } else if (kind == Kind::kNone) {
    EXPECT_FALSE(verdict.surely_shadow);
  }
}

TEST(PlainFlags, AgreeWithBruteForceOnRandomScans) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in_map(-1.9, 2.4);
  for (int round = 0; round < 20; ++round) {
    const Eigen::Vector3d sensor(in_map(random), in_map(random), in_map(random));
    Scan scan = scan_at(0, sensor);
    std::vector<VoxelIndex> hits;
    for (int i = 0; i < 10; ++i) {
      const Eigen::Vector3d p(in_map(random), in_map(random), in_map(random));
      scan.points.push_back((p - sensor).cast<float>());
      hits.push_back(voxel_at(p, kResolution));
    }
    const std::vector<Verdict> verdicts = judge(sensor, hits);
    const std::vector<VoxelFlag> flags = flag_voxels(scan, kWindow, kResolution, true);
    for_each_voxel(kWindow, [&](const VoxelIndex& v, std::size_t i) {
      const Kind kind = flags[i].kind;
      const bool is_hit = std::find(hits.begin(), hits.end(), v) != hits.end();
      EXPECT_EQ(kind == Kind::kOccupied, is_hit);
      if (!is_hit) expect_possible(kind, verdicts[i]);
    });
  }
}

}  // namespace
}  // namespace ldm::plain
