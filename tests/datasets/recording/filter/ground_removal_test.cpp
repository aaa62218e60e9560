/// Ground removal on roads that slope, bend and carry cars: shares of ground and obstacles.
#include "datasets/recording/filter/ground_removal.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <numbers>

#include "datasets/random.h"

namespace datasets {
namespace {

constexpr double kHeight = 1.7;  // of the sensor above the ground under it [m]

/// A sweep over hilly ground with boxes on it, by stepping along each ray.
struct World {
  std::function<double(double, double)> ground;  // height at x, y; 0 below the sensor
  struct Box {
    double x, y, length, width, height, clearance = 0;
  };
  std::vector<Box> boxes;

  bool in_box(const Eigen::Vector3d& p) const {
    for (const Box& b : boxes) {
      const double above = p.z() - ground(b.x, b.y);
      if (std::abs(p.x() - b.x) < b.length / 2 && std::abs(p.y() - b.y) < b.width / 2 &&
          above > b.clearance && above < b.height) {
        return true;
      }
    }
    return false;
  }
};

struct Sweep {
  ldm::Scan scan;
  std::vector<bool> on_ground;
};

/// 32 channels from -25 to 5 degrees, 720 azimuths, 2 cm of noise.
Sweep sweep(const World& world, const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
  Sweep result;
  result.scan.T_world_sensor = {turn, {0, 0, kHeight}};
  Random random(5);
  for (int channel = 0; channel < 32; ++channel) {
    const double elevation = (-25 + 30.0 * channel / 31) * std::numbers::pi / 180;
    for (int i = 0; i < 720; ++i) {
      const double azimuth = i * std::numbers::pi / 360;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      for (double range = 0.5; range < 45; range += 0.05) {
        const Eigen::Vector3d p = Eigen::Vector3d(0, 0, kHeight) + range * ray;
        const bool box = world.in_box(p);
        if (!box && p.z() > world.ground(p.x(), p.y())) continue;
        const double noise = 0.02 * normal_of(random.bits());
        result.scan.points.push_back(
            (turn.transpose() * ((range - 0.025 + noise) * ray)).cast<float>());
        result.on_ground.push_back(!box);
        break;
      }
    }
  }
  return result;
}

struct Shares {
  double ground_removed, obstacles_kept;
};

/// @param near only points within this distance count [m]
Shares shares(const Sweep& sweep, GroundRemoval removal, double near = 30) {
  GroundParameters parameters;
  parameters.removal = removal;
  GroundFinder finder(parameters);
  std::vector<std::uint8_t> is_ground;
  EXPECT_TRUE(finder.mark(sweep.scan, is_ground));
  double ground = 0, removed = 0, obstacles = 0, kept = 0;
  for (std::size_t i = 0; i < is_ground.size(); ++i) {
    if (sweep.scan.points[i].norm() > static_cast<float>(near)) continue;
    (sweep.on_ground[i] ? ground : obstacles) += 1;
    if (sweep.on_ground[i]) removed += is_ground[i];
    if (!sweep.on_ground[i]) kept += 1 - is_ground[i];
  }
  return {removed / ground, kept / obstacles};
}

/// Cars parked on both sides, a wall, people.
std::vector<World::Box> street() {
  std::vector<World::Box> boxes;
  for (int i = -3; i <= 3; ++i) {
    boxes.push_back({6.0 * i + 3, 4, 4.5, 1.8, 1.5, 0.2});
    boxes.push_back({6.0 * i, -4, 4.5, 1.8, 1.5, 0.2});
  }
  boxes.push_back({0, 12, 60, 0.5, 6});
  boxes.push_back({8, 0, 0.5, 0.5, 1.75});
  boxes.push_back({14, 1, 0.5, 0.5, 1.75});
  return boxes;
}

TEST(GroundRemoval, ALevelStreet) {
  const Sweep level = sweep({[](double, double) { return 0.0; }, street()});
  for (const GroundRemoval removal : {GroundRemoval::kPlane, GroundRemoval::kGrid}) {
    const Shares s = shares(level, removal);
    EXPECT_GT(s.ground_removed, 0.995);
    EXPECT_GT(s.obstacles_kept, 0.9);
  }
}

TEST(GroundRemoval, AStreetOfTwelvePerCent) {
  const Sweep steep = sweep({[](double x, double y) { return 0.12 * x - 0.05 * y; }, street()});
  for (const GroundRemoval removal : {GroundRemoval::kPlane, GroundRemoval::kGrid}) {
    const Shares s = shares(steep, removal);
    EXPECT_GT(s.ground_removed, 0.99);
    EXPECT_GT(s.obstacles_kept, 0.9);
  }
}

TEST(GroundRemoval, TheSensorMayBeTilted) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.15, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const Shares s =
      shares(sweep({[](double, double) { return 0.0; }, street()}, turn), GroundRemoval::kPlane);
  EXPECT_GT(s.ground_removed, 0.995);
  EXPECT_GT(s.obstacles_kept, 0.9);
}

/// Level for 6 m, then up at 10 %: a plane cannot be both.
TEST(GroundRemoval, TheGridFollowsARampThatThePlaneMisses) {
  const auto ramp = [](double x, double) { return x < 6 ? 0.0 : 0.1 * (x - 6); };
  const Sweep bent = sweep({ramp, street()});
  const Shares grid = shares(bent, GroundRemoval::kGrid);
  EXPECT_GT(grid.ground_removed, 0.98);
  EXPECT_GT(grid.obstacles_kept, 0.85);
  EXPECT_LT(shares(bent, GroundRemoval::kPlane).ground_removed, grid.ground_removed);
}

TEST(GroundRemoval, TheGridFollowsHills) {
  const auto hills = [](double x, double y) {
    return 0.6 * (std::sin(x / 8) + std::sin(y / 11)) - 0.1 * x;
  };
  const Shares s = shares(sweep({hills, {{8, 0, 0.5, 0.5, 1.75}, {-7, 4, 4, 2, 1.5, 0.2}}}),
                          GroundRemoval::kGrid, 20);
  EXPECT_GT(s.ground_removed, 0.97);
  EXPECT_GT(s.obstacles_kept, 0.85);
}

TEST(GroundRemoval, PointsBelowTheGroundAreNotTheGround) {
  Sweep level = sweep({[](double, double) { return 0.0; }, street()});
  for (int i = 0; i < 500; ++i) {  // mirror images in puddles
    level.scan.points.emplace_back(4.0F + 0.01F * static_cast<float>(i), 1, -4);
    level.on_ground.push_back(true);
  }
  const Shares s = shares(level, GroundRemoval::kGrid);
  EXPECT_GT(s.ground_removed, 0.99);
  EXPECT_GT(s.obstacles_kept, 0.9);
}

TEST(GroundRemoval, WithoutGroundThereIsNone) {
  ldm::Scan wall;
  for (int i = 0; i < 3000; ++i) {
    wall.points.emplace_back(5, 0.1F * static_cast<float>(i % 60) - 3,
                             0.04F * static_cast<float>(i / 60) + 0.3F);
  }
  for (const GroundRemoval removal : {GroundRemoval::kPlane, GroundRemoval::kGrid}) {
    GroundParameters parameters;
    parameters.removal = removal;
    std::vector<std::uint8_t> is_ground;
    EXPECT_FALSE(GroundFinder(parameters).mark(wall, is_ground));
    EXPECT_EQ(is_ground, std::vector<std::uint8_t>(wall.points.size(), 0));
    EXPECT_FALSE(GroundFinder(parameters).mark({}, is_ground));
  }
}

TEST(GroundRemoval, TheSamePointsGiveTheSameBits) {
  const Sweep level = sweep({[](double x, double) { return 0.02 * x; }, street()});
  GroundParameters parameters;
  parameters.removal = GroundRemoval::kGrid;
  std::vector<std::uint8_t> first, second;
  GroundFinder finder(parameters);
  finder.mark(level.scan, first);
  finder.mark(sweep({[](double, double) { return 0.3; }, street()}).scan, second);
  finder.mark(level.scan, second);
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace datasets
