/// Rays that met nothing, of a sensor that moves while it scans.
#include "datasets/recording/rays/scan_rays.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "datasets/frame.h"
#include "datasets/random.h"
#include "datasets/recording/rays/firing_times.h"
#include "datasets/recording/rays/gap_rays.h"
#include "ldm/plain/measurement_flags.h"

namespace datasets {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(FiringTimes, RunEvenlyBetweenReturns) {
  // A turn of 0.1 s from -180 degrees on, without returns from 0 to 90.
  std::vector<ldm::Point> points = {ldm::Point::Constant(NAN), ldm::Point::Zero()};
  std::vector<float> delays = {5, 5};
  for (int degrees = -180; degrees < 180; ++degrees) {
    if (degrees >= 0 && degrees < 90) continue;
    const double azimuth = kDegree * (degrees + 0.1);
    points.push_back(Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0).cast<float>());
    delays.push_back(static_cast<float>(0.1 * (degrees + 180) / 360));
  }
  delays[0] = delays[1] = 0;
  const FiringTimes times(points, delays);
  for (const double degrees : {-150.0, -20.0, 10.0, 45.0, 80.0, 120.0, 170.0}) {
    const auto at = times.at(kDegree * degrees);
    ASSERT_TRUE(at) << degrees;
    EXPECT_NEAR(*at, 0.1 * (degrees + 180) / 360, 4e-4) << degrees;
    EXPECT_NEAR(times.at(kDegree * (degrees - 360)).value_or(9), *at, 2e-4);
  }
}

TEST(FiringTimes, AreNotKnownWhereATurnEnds) {
  std::vector<ldm::Point> points;
  std::vector<float> delays;
  for (int degrees = -170; degrees < 170; ++degrees) {  // nothing returns around 180
    points.push_back(
        Eigen::Vector3d(std::cos(kDegree * degrees), std::sin(kDegree * degrees), 0).cast<float>());
    delays.push_back(static_cast<float>(degrees));
  }
  EXPECT_FALSE(FiringTimes(points, delays).at(kDegree * 175));
  EXPECT_FALSE(FiringTimes(points, delays).at(kDegree * -175));
  EXPECT_TRUE(FiringTimes(points, delays).at(kDegree * 160));
  EXPECT_FALSE(FiringTimes({}, {}).at(0));
}

using Flag = ldm::plain::VoxelFlag;

/// Boxes that stand around, each with two corners.
using Boxes = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;

Boxes boxes_around() {
  Boxes boxes = {{{-6, -1, -2}, {-5, 1, 2}}};  // where the turn begins and ends
  for (std::uint64_t i = 0; i < 14; ++i) {
    if (i == 7) continue;
    const auto share = [i](std::uint64_t key) {
      return 0.5 + 0.5 * std::sin(static_cast<double>(random_bits(key, i) % 10000));
    };
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / 14;
    const double range = 3 + 5 * share(1), size = 0.3 + share(2);
    const Eigen::Vector3d low(range * std::cos(angle), range * std::sin(angle), -1.5);
    boxes.emplace_back(low, low + Eigen::Vector3d(size, size, 1 + 2 * share(3)));
  }
  return boxes;
}

/// Range of the first box on a ray, or infinity [m].
double range_to(const Boxes& boxes, const Eigen::Vector3d& begin, const Eigen::Vector3d& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [low, high] : boxes) {
    const Eigen::Array3d a = (low - begin).array() / ray.array();
    const Eigen::Array3d b = (high - begin).array() / ray.array();
    const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
    if (enter > 0 && enter <= leave) nearest = std::min(nearest, enter);
  }
  return nearest;
}

constexpr double kResolution = 0.15;  // [m]

std::vector<Flag> flags_of(const ldm::Scan& scan) {
  const ldm::VoxelIndex size(96, 96, 24);
  return ldm::plain::flag_voxels(scan, {ldm::VoxelIndex(0, 0, 0) - size / 2, size}, kResolution,
                                 true);
}

struct Found {
  std::int64_t lost = 0, recovered = 0, all = 0, solid = 0, solid_without = 0;
  std::size_t rays = 0, missing = 0;

  double recovered_share() const {
    return static_cast<double>(recovered) / static_cast<double>(lost);
  }
  double solid_share() const { return static_cast<double>(solid) / static_cast<double>(all); }
};

/// Scans of 0.1 s by 32 rings of 512 firings, of a sensor that moves at `speed` [m/s] and turns at
/// `turn` [rad/s] among boxes; their time is in the middle. Counted are voxels that true rays make
/// free (each from where it was fired) and returns alone do not, and those that found ones do.
Found found_at(double speed, double turn, bool gaps = false) {
  const Boxes boxes = boxes_around();
  ScanRays missing(true);
  Found result;
  for (int i = 0; i < 6; ++i) {
    const auto sensor_at = [&](double delay) {
      const double t = delay + 0.1 * (i - 3);
      ldm::Pose pose;
      pose.rotation = Eigen::AngleAxisd(turn * t, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      pose.translation << speed * t, 0.2 * speed * t, 0;
      return std::optional(pose);
    };
    ldm::Scan scan;
    std::vector<float> delays;
    std::vector<std::uint8_t> truly_free;
    for (int column = 0; column < 512; ++column) {
      const double delay = 0.1 * column / 512 - 0.05;
      const double azimuth = std::numbers::pi - 2 * std::numbers::pi * (column + 0.5) / 512;
      ldm::Scan one;
      one.T_world_sensor = one.T_world_uav = *sensor_at(delay);
      for (int ring = 0; ring < 32; ++ring) {
        const double elevation = kDegree * (ring - 16);
        const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        const double range =
            range_to(boxes, one.T_world_sensor.translation, one.T_world_sensor.rotation * ray);
        if (range > 60) {
          one.no_returns.push_back(ray.cast<float>());
          continue;
        }
        one.points.push_back((range * ray).cast<float>());
        scan.points.push_back(one.points.back());
        delays.push_back(static_cast<float>(delay));
      }
      result.missing += one.no_returns.size();
      if (i < 5) continue;
      const std::vector<Flag> flags = flags_of(one);
      truly_free.resize(flags.size());
      for (std::size_t k = 0; k < flags.size(); ++k) {
        truly_free[k] |= flags[k].kind == Flag::Kind::kFree;
      }
    }
    scan.T_world_sensor = scan.T_world_uav = *sensor_at(0);
    TimedRays rays = missing.of(scan.points, delays);
    EXPECT_TRUE(deskew(delays, scan.T_world_sensor, sensor_at, scan.points, rays));
    if (gaps) {
      rays.rays.clear();
      EXPECT_TRUE(GapRays().find(scan.points, rays.rays));
    }
    result.rays += rays.rays.size();
    if (i < 5) continue;
    const std::vector<Flag> without = flags_of(scan);
    scan.no_returns = rays.rays;
    const std::vector<Flag> with = flags_of(scan);
    const auto free = [](const Flag& flag) { return flag.kind == Flag::Kind::kFree; };
    for (std::size_t k = 0; k < with.size(); ++k) {
      const auto n = static_cast<int>(k);
      const Eigen::Vector3d centre =
          kResolution *
          (Eigen::Vector3d(n % 96 - 48, n / 96 % 96 - 48, n / 96 / 96 - 12).array() + 0.5).matrix();
      const bool solid = std::any_of(boxes.begin(), boxes.end(), [&](const auto& box) {
        return (centre.array() >= box.first.array()).all() &&
               (centre.array() <= box.second.array()).all();
      });
      result.lost += truly_free[k] != 0 && !free(without[k]);
      result.recovered += truly_free[k] != 0 && !free(without[k]) && free(with[k]);
      result.all += free(with[k]);
      result.solid += free(with[k]) && solid && truly_free[k] == 0;
      result.solid_without += free(without[k]) && solid && truly_free[k] == 0;
    }
  }
  return result;
}

TEST(ScanRays, OfASensorInMotionMarkTheSameSpaceFree) {
  const std::pair<double, double> motions[] = {{0, 0}, {1.5, 0}, {1.5, 0.7}, {5, 0.3}};
  for (const auto& [speed, turn] : motions) {
    const Found found = found_at(speed, turn);
    RecordProperty("recovered_at_" + std::to_string(speed),
                   std::to_string(found.recovered_share()));
    RecordProperty("solid_at_" + std::to_string(speed), std::to_string(found.solid_share()));
    EXPECT_GT(found.lost, 10000);
    EXPECT_GT(found.recovered_share(), speed < 2 ? 0.95 : 0.93) << speed << ' ' << turn;
    EXPECT_LT(found.solid_share(), 0.001) << speed << ' ' << turn;
  }
}

// Gaps of scans that were moved, of which nothing tells when the points were measured.
TEST(GapRays, OfASensorInMotionMarkMostOfTheSameSpaceFree) {
  const std::pair<double, double> motions[] = {{0, 0}, {1.5, 0.7}, {5, 0.3}, {10, 0}};
  for (const auto& [speed, turn] : motions) {
    const Found found = found_at(speed, turn, true);
    EXPECT_GT(found.recovered_share(), 0.85) << speed << ' ' << turn;
    EXPECT_LT(found.solid_share(), 0.0001) << speed << ' ' << turn;
  }
}

TEST(GapRays, OfFewPointsAreNone) {
  std::vector<ldm::Point> rays;
  EXPECT_FALSE(GapRays().find({}, rays));
  EXPECT_FALSE(GapRays().find(std::vector<ldm::Point>(5000, ldm::Point(3, 0, 0)), rays));
  EXPECT_TRUE(rays.empty());
}

// At 20 m/s the sensor is farther than 0.3 m from where it is at the scan's time, but for a third.
TEST(ScanRays, FiredFarFromTheScansOriginAreLeftOut) {
  const Found found = found_at(20, 0);
  const double share = static_cast<double>(found.rays) / static_cast<double>(found.missing);
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.35);
}

TEST(ScanRays, AreNotSoughtIfToldSo) {
  ScanRays none(false);
  EXPECT_TRUE(none.of({{1, 0, 0}, {0, 1, 0}}, {}).rays.empty());
  InputCounts counts;
  none.count(counts.other);
  EXPECT_TRUE(counts.other.empty());
  ScanRays sought(true);
  EXPECT_TRUE(sought.of({{1, 0, 0}, {0, 1, 0}}, {}).rays.empty());
  sought.count(counts.other);
  EXPECT_EQ(counts.other, (InputCounts::ByReason{{MissingRays::kNotCertain, 1}}));
}

}  // namespace
}  // namespace datasets
