/// Rays that met nothing, found again in scans that lack them.
#include "datasets/recording/rays/missing_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "datasets/random.h"
#include "datasets/scenario/simulation.h"
#include "ldm/plain/measurement_flags.h"
#include "tests/source_folder.h"

namespace datasets {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kNothing = std::numeric_limits<double>::infinity();

/// A sensor of rings, each with 360 firings a turn, or fewer.
struct Sensor {
  double first = -15, spacing = 2;  ///< [deg]
  int rings = 16;
  int step = 1;  ///< [deg]

  ldm::Point direction(int ring, int degree) const {
    const double e = kDegree * (first + spacing * ring), a = kDegree * degree;
    return Eigen::Vector3d(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e))
        .cast<float>();
  }
  /// Its returns, at range_of(ring, degree) [m].
  std::vector<ldm::Point> scan(const std::function<double(int, int)>& range_of) const {
    std::vector<ldm::Point> points;
    for (int ring = 0; ring < rings; ++ring) {
      for (int degree = -180; degree < 180; degree += step) {
        const double range = range_of(ring, degree);
        if (range < kNothing) points.push_back(static_cast<float>(range) * direction(ring, degree));
      }
    }
    return points;
  }
};

std::vector<ldm::Point> found(MissingRays& missing, const std::vector<ldm::Point>& points) {
  std::vector<ldm::Point> rays;
  EXPECT_TRUE(missing.find(points, rays));
  for (const ldm::Point& ray : rays) EXPECT_NEAR(ray.norm(), 1, 1e-6);
  return rays;
}

/// True if one of `rays` is that of the sensor.
bool has(const std::vector<ldm::Point>& rays, const ldm::Point& direction) {
  return std::any_of(rays.begin(), rays.end(),
                     [&](const ldm::Point& ray) { return (ray - direction).norm() < 1e-4F; });
}

TEST(MissingRays, AreTheDirectionsWithoutAReturn) {
  const Sensor sensor;
  const auto gap = [](int ring, int degree) {
    return ring == 3 && degree >= 10 && degree < 40;  // and around the end of the turn:
  };
  MissingRays missing;
  const auto rays = found(missing, sensor.scan([&](int ring, int degree) {
    return gap(ring, degree) || std::abs(degree) > 170 ? kNothing : 10;
  }));
  EXPECT_EQ(rays.size(), 30U + 16 * 19);
  for (int degree = 10; degree < 40; ++degree) EXPECT_TRUE(has(rays, sensor.direction(3, degree)));
  EXPECT_TRUE(has(rays, sensor.direction(0, 171)));
  EXPECT_TRUE(has(rays, sensor.direction(15, -180)));
}

TEST(MissingRays, PixelsWithoutAReturnAreNoPoints) {
  const Sensor sensor;
  const auto range_of = [](int, int degree) { return degree > 150 ? kNothing : 10; };
  std::vector<ldm::Point> points = sensor.scan(range_of);
  MissingRays missing;
  const std::size_t rays = found(missing, points).size();
  EXPECT_EQ(rays, 16U * 29);
  points.insert(points.begin() + 100, 500, ldm::Point::Zero());
  points.insert(points.begin() + 900, 500, ldm::Point::Constant(NAN));
  EXPECT_EQ(found(missing, points).size(), rays);
}

TEST(MissingRays, AHoleInASurfaceIsNoFreeSpace) {
  const Sensor sensor;
  MissingRays missing;
  const auto window = [&](double range, double behind) {
    return found(missing, sensor.scan([=](int ring, int degree) {
             if (degree >= 180 - 1) return range;
             if (ring == 7 && degree >= 0 && degree < 4) return kNothing;
             return degree < 0 ? range : behind;
           }))
        .size();
  };
  EXPECT_EQ(window(10, 10), 0U);    // 0.87 m wide
  EXPECT_EQ(window(10, 10.8), 0U);  // a slanted surface
  EXPECT_EQ(window(10, 12), 4U);    // two surfaces
  EXPECT_EQ(window(15, 15), 4U);    // 1.31 m
}

TEST(MissingRays, OfNoPatternAreNone) {
  std::vector<ldm::Point> points;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const auto number = [i](std::uint64_t key) {
      return static_cast<float>(normal_of(random_bits(key, i)));
    };
    points.push_back(10 * ldm::Point(number(1), number(2), number(3)).normalized());
  }
  std::vector<ldm::Point> rays;
  MissingRays missing;
  EXPECT_FALSE(missing.find(points, rays));
  EXPECT_FALSE(missing.find({}, rays));
  EXPECT_TRUE(rays.empty());
}

TEST(MissingRays, OfAnEmptyScanAreNone) {
  const Sensor sensor;
  MissingRays missing;
  found(missing, sensor.scan([](int, int) { return 10; }));
  std::vector<ldm::Point> rays;
  EXPECT_FALSE(missing.find({}, rays));
  EXPECT_FALSE(missing.find(std::vector<ldm::Point>(500, ldm::Point::Zero()), rays));
  EXPECT_TRUE(rays.empty());
}

TEST(MissingRays, OfAScanInMotionAreNone) {
  const Sensor sensor;
  const auto range_of = [](int, int degree) { return degree > 90 ? kNothing : 5; };
  std::vector<ldm::Point> points = sensor.scan(range_of), rays;
  MissingRays missing;
  EXPECT_TRUE(missing.find(points, rays));
  rays.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t firing = i % (points.size() / 16);
    points[i].x() += 0.005F * static_cast<float>(firing);  // 1.35 m a turn
  }
  EXPECT_FALSE(missing.find(points, rays));
  EXPECT_TRUE(rays.empty());
}

TEST(MissingRays, NothingIsSaidOfWhereNothingEverReturned) {
  const Sensor sensor;
  MissingRays missing;
  const auto rays = found(missing, sensor.scan([](int ring, int degree) {
    const bool gap = ring == 3 && degree > -40 && degree < 0;
    return std::abs(degree) > 60 || gap ? kNothing : 10;
  }));
  for (const ldm::Point& ray : rays) {
    EXPECT_LT(std::abs(std::atan2(ray.y(), ray.x())), (60 + 35 + 0.1) * kDegree);
  }
  EXPECT_TRUE(has(rays, sensor.direction(3, -20)));
  EXPECT_TRUE(has(rays, sensor.direction(0, 85)));
}

// 0.03 m at 1 m are 1.7 degrees: the return may be of either of the rings beside its own.
TEST(MissingRays, BesideANearReturnTheRingIsNotCertain) {
  const Sensor sensor{.first = -7.5, .spacing = 1, .rings = 16};
  MissingRays missing;
  const auto rays = found(missing, sensor.scan([](int ring, int degree) {
    if (degree == 30 && ring == 8) return 1.0;
    return degree > 20 && degree < 90 ? kNothing : 20;
  }));
  EXPECT_TRUE(has(rays, sensor.direction(5, 30)));
  EXPECT_FALSE(has(rays, sensor.direction(7, 30)));
  EXPECT_FALSE(has(rays, sensor.direction(9, 30)));
  EXPECT_TRUE(has(rays, sensor.direction(11, 30)));
  EXPECT_TRUE(has(rays, sensor.direction(9, 32)));
}

// As an Ouster's: a wall at 1.2 m is seen where rings of far returns are not.
TEST(MissingRays, NoneGoesThroughAWallThatIsNear) {
  const Sensor sensor{.first = -16, .spacing = 0.5, .rings = 64};
  std::vector<ldm::Point> points;
  const auto wall = [](int degree) { return degree >= 0 && degree < 60; };
  for (int ring = 0; ring < 64; ++ring) {
    for (int degree = -180; degree < 180; ++degree) {
      if (degree >= 100 && degree < 120) continue;
      const ldm::Point ray = sensor.direction(ring, degree);
      const float a = static_cast<float>(kDegree) * static_cast<float>(degree);
      const ldm::Point begin = 0.028F * ldm::Point(std::cos(a), std::sin(a), 0);
      points.push_back(begin + (wall(degree) ? 1.2F : 15.0F) * ray);
    }
  }
  MissingRays missing;
  const auto rays = found(missing, points);
  EXPECT_EQ(rays.size(), 64u * 20);
  for (const ldm::Point& ray : rays) {
    EXPECT_FALSE(wall(static_cast<int>(std::lround(std::atan2(ray.y(), ray.x()) / kDegree))));
  }
}

// Rings 2, 5 and 12 to 15 never returned anything: those between others are found by the spacing,
// those above by the model, if it is one.
TEST(MissingRays, RingsWithoutAReturnFollowFromTheOthers) {
  const auto range_of = [](int ring, int) {
    return ring == 2 || ring == 5 || ring >= 12 ? kNothing : 10;
  };
  const Sensor vlp16, other{.first = -16, .spacing = 2.2, .rings = 16};
  MissingRays missing, missing_other;
  const auto rays = found(missing, vlp16.scan(range_of));
  EXPECT_EQ(rays.size(), 6U * 360);
  EXPECT_TRUE(has(rays, vlp16.direction(15, 77)));
  const auto rays_of_other = found(missing_other, other.scan(range_of));
  EXPECT_EQ(rays_of_other.size(), 2U * 360);
  EXPECT_TRUE(has(rays_of_other, other.direction(5, 77)));
}

// What a packet that was lost would have said is not known.
TEST(MissingRays, NothingIsSaidOfWhatWasLost) {
  const Sensor sensor;
  const auto points = sensor.scan([](int, int degree) {
    return (degree >= 20 && degree < 50) || std::abs(degree) > 160 ? kNothing : 10;
  });
  LostAzimuths lost;
  lost.add(29.5 * kDegree, 10 * kDegree);
  lost.add(169.5 * kDegree, 21 * kDegree);
  MissingRays missing;
  std::vector<ldm::Point> rays;
  EXPECT_TRUE(missing.find(points, rays, lost));
  EXPECT_EQ(rays.size(), 16U * (20 + 39 - 21));
  EXPECT_TRUE(has(rays, sensor.direction(0, 29)));
  EXPECT_FALSE(has(rays, sensor.direction(0, 30)));
  EXPECT_FALSE(has(rays, sensor.direction(0, 39)));
  EXPECT_TRUE(has(rays, sensor.direction(0, 40)));
  EXPECT_TRUE(has(rays, sensor.direction(0, 169)));
  EXPECT_FALSE(has(rays, sensor.direction(0, -180)));
  EXPECT_TRUE(has(rays, sensor.direction(0, -169)));
  rays.clear();
  EXPECT_TRUE(missing.find(points, rays));
  EXPECT_EQ(rays.size(), 16U * (30 + 39));
}

// Steps of half and twice the width, beams elsewhere, every other beam and twice as many: after
// the change there are no rays, or the right ones; and these from the 40th scan on at the latest.
TEST(MissingRays, APatternThatChangesIsForgotten) {
  const Sensor before{.first = -15, .spacing = 2, .rings = 16, .step = 2};
  const Sensor others[] = {{.first = -15, .spacing = 2, .rings = 16, .step = 1},
                           {.first = -15, .spacing = 2, .rings = 16, .step = 4},
                           {.first = -14, .spacing = 2, .rings = 16, .step = 2},
                           {.first = -14.3, .spacing = 2, .rings = 12, .step = 2},
                           {.first = -15, .spacing = 4, .rings = 8, .step = 2},
                           {.first = -15, .spacing = 1, .rings = 31, .step = 2}};
  const auto range_of = [](int ring, int degree) {
    if (degree >= 20 && degree < 60) return kNothing;
    return degree / 4 % 2 == 0 || ring % 3 == 0 ? 12.0 : 25.0;
  };
  for (const Sensor& after : others) {
    MissingRays missing;
    for (int i = 0; i < 30; ++i) found(missing, before.scan(range_of));
    const auto points = after.scan(range_of);
    const auto open = static_cast<std::size_t>(after.rings) * 40 / after.step;
    int certain = 0;
    for (int i = 0; i < 50; ++i) {
      std::vector<ldm::Point> rays;
      certain += missing.find(points, rays);
      EXPECT_EQ(rays.empty(), certain == 0);
      const int since = std::max(0, i - 39);
      EXPECT_GE(certain, since) << after.first << ' ' << after.spacing << ' ' << after.step;
      if (rays.empty()) continue;
      EXPECT_EQ(rays.size(), open) << i << ' ' << after.first << ' ' << after.step;
      EXPECT_TRUE(has(rays, after.direction(1, 40)));
    }
    EXPECT_GE(certain, 10) << after.first << ' ' << after.spacing << ' ' << after.step;
  }
}

// Scans in motion lie on no rings; with the pattern that they blur the one before comes back.
TEST(MissingRays, AfterMotionThePatternIsFoundAgain) {
  const Sensor sensor;
  const auto points = sensor.scan([](int, int degree) { return degree > 90 ? kNothing : 5; });
  MissingRays missing;
  const std::size_t rays_before = found(missing, points).size();
  for (int k = 0; k < 50; ++k) {
    std::vector<ldm::Point> moved = points, rays;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      moved[i].z() += 0.002F * static_cast<float>(i % (points.size() / 16));  // 0.5 m a turn
    }
    EXPECT_FALSE(missing.find(moved, rays));
  }
  for (int k = 0; k < 40; ++k) {
    std::vector<ldm::Point> rays;
    missing.find(points, rays);
  }
  EXPECT_EQ(found(missing, points).size(), rays_before);
}

using Flag = ldm::plain::VoxelFlag;

std::vector<Flag> flags_of(const ldm::Scan& scan, const ldm::VoxelIndex& size, double resolution) {
  const ldm::VoxelIndex centre = ldm::voxel_at(scan.T_world_uav.translation, resolution);
  return ldm::plain::flag_voxels(scan, {centre - size / 2, size}, resolution, true);
}

struct Simulated {
  const char* name;
  std::vector<std::pair<std::string, std::string>> settings;
  ldm::VoxelIndex size;
  double resolution;
};

class MissingRaysOf : public testing::TestWithParam<Simulated> {};

/// Of the voxels that are free by rays without a return alone, found are 95 %; of those that are
/// free with what was found, less than 0.1 % are not free with the true rays.
TEST_P(MissingRaysOf, ASimulationMarkTheSameSpaceFree) {
  Scenario scenario = read_scenario(tests::source_folder() / "datasets/scenarios/scenario3.toml");
  for (const auto& [name, value] : GetParam().settings) set_scenario_value(scenario, name, value);
  Simulation simulation(scenario, 7, 30);
  MissingRays missing;
  Frame frame;
  std::int64_t lost = 0, recovered = 0, wrong = 0, all = 0;
  while (simulation.next(frame)) {
    ldm::Scan scan = frame.scan;
    scan.no_returns.clear();
    const bool certain = missing.find(scan.points, scan.no_returns);
    if (frame.index % 10 != 9) continue;
    ASSERT_TRUE(certain);
    const auto flags = [&](const ldm::Scan& s) {
      return flags_of(s, GetParam().size, GetParam().resolution);
    };
    const std::vector<Flag> truth = flags(frame.scan), found = flags(scan);
    scan.no_returns.clear();
    const std::vector<Flag> without = flags(scan);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto free = [i](const std::vector<Flag>& f) { return f[i].kind == Flag::Kind::kFree; };
      lost += free(truth) && !free(without);
      recovered += free(truth) && !free(without) && free(found);
      all += free(found);
      wrong += free(found) && !free(truth);
    }
  }
  const auto share = [](std::int64_t part, std::int64_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
  };
  EXPECT_GT(lost, 10000);
  EXPECT_GT(share(recovered, lost), 0.95);
  EXPECT_LT(share(wrong, all), 0.001);
  RecordProperty("recovered", std::to_string(share(recovered, lost)));
  RecordProperty("wrong", std::to_string(share(wrong, all)));
}

const std::vector<std::pair<std::string, std::string>> kWide = {{"area.size_m", "60,60"},
                                                                {"groups.boxes.count", "30"},
                                                                {"groups.boxes.height_m", "1,4"},
                                                                {"groups.boxes.width_m", "0.3,3"},
                                                                {"groups.boxes.bottom_m", "0,0.5"}};

std::vector<std::pair<std::string, std::string>> with(
    std::vector<std::pair<std::string, std::string>> settings,
    const std::vector<std::pair<std::string, std::string>>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

INSTANTIATE_TEST_SUITE_P(
    Sensors, MissingRaysOf,
    testing::Values(
        Simulated{"paper", {{"sensor.range_sigma_m", "0.005"}}, {32, 32, 32}, 0.15},
        Simulated{"paper_noisy", {{"sensor.range_sigma_m", "0.05"}}, {32, 32, 32}, 0.15},
        Simulated{
            "dense", {{"sensor.channels", "64"}, {"sensor.azimuths", "2048"}}, {32, 32, 32}, 0.15},
        Simulated{"wide", kWide, {96, 96, 32}, 0.3},
        Simulated{"wide_dense",
                  with(kWide, {{"sensor.channels", "64"},
                               {"sensor.azimuths", "2048"},
                               {"sensor.range_sigma_m", "0.05"}}),
                  {96, 96, 32},
                  0.3}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace datasets
