/// The ray caster: against closed forms, and its windows against all rays.
#include "datasets/scenario/lidar_caster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "datasets/scenario/ray_entry.h"
#include "tests/datasets/scenario/random_solids.h"

namespace datasets {
namespace {

constexpr Solid::Shape kShapes[] = {Solid::Shape::kBox, Solid::Shape::kCylinder,
                                    Solid::Shape::kSphere};

/// The paper's beam pattern, without noise.
LidarModel exact_lidar() {
  LidarModel model;
  for (int i = 0; i < 16; ++i) {
    model.elevations.push_back((-16.6 + 33.2 * i / 15) * std::numbers::pi / 180);
  }
  model.range_sigma = 0;
  return model;
}

ObjectState object_of(const Solid& solid) {
  ObjectState object;
  object.solids = {solid};
  return object;
}

Solid upright(Solid::Shape shape, const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
  return {shape, {Eigen::Matrix3d::Identity(), centre}, size};
}

struct CastResult {
  RangeImage image;
  std::vector<ldm::Point> hits;
};

CastResult cast(const LidarModel& model, const ldm::Pose& pose,
                const std::vector<ObjectState>& objects, std::uint64_t noise_key = 1) {
  LidarCaster caster(model);
  CastResult result;
  caster.cast(pose, objects, noise_key, result.image, result.hits);
  return result;
}

double entry(const Solid& solid, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const Eigen::Matrix3d to_solid = solid.T_world_solid.rotation.transpose();
  const Eigen::Vector3d o = to_solid * (origin - solid.T_world_solid.translation);
  const Eigen::Vector3d d = to_solid * direction;
  switch (solid.shape) {
    case Solid::Shape::kBox:
      return box_entry(solid.size / 2, o, d);
    case Solid::Shape::kCylinder:
      return cylinder_entry(solid.size / 2, o, d);
    case Solid::Shape::kSphere:
      return sphere_entry(solid.size / 2, o, d);
  }
  return kNever;
}

TEST(RayEntryTest, SphereAgainstItsClosedForm) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5);
  // A ray that passes the centre at distance b enters sqrt(r^2 - b^2) before the nearest point.
  EXPECT_DOUBLE_EQ(sphere_entry(half, {-3, 0, 0}, {1, 0, 0}), 2.5);
  EXPECT_DOUBLE_EQ(sphere_entry(half, {-3, 0.3, 0}, {1, 0, 0}), 2.6);
  EXPECT_EQ(sphere_entry(half, {-3, 0.5001, 0}, {1, 0, 0}), kNever);
  EXPECT_EQ(sphere_entry(half, {3, 0, 0}, {1, 0, 0}), kNever) << "behind";
  EXPECT_EQ(sphere_entry(half, {0.1, 0, 0}, {1, 0, 0}), kNever) << "from inside";
}

TEST(RayEntryTest, BoxFaces) {
  const Eigen::Vector3d half(1, 2, 3);
  EXPECT_DOUBLE_EQ(box_entry(half, {-4, 0.5, 0.5}, {1, 0, 0}), 3);
  EXPECT_DOUBLE_EQ(box_entry(half, {4, 0.5, 0.5}, {-1, 0, 0}), 3);
  EXPECT_DOUBLE_EQ(box_entry(half, {0.5, -4, 0.5}, {0, 1, 0}), 2);
  EXPECT_DOUBLE_EQ(box_entry(half, {0.5, 0.5, 7}, {0, 0, -1}), 4);
  EXPECT_DOUBLE_EQ(box_entry(half, {-3, 0, 0}, {0.8, 0.6, 0}), 2.5) << "x = -1, y = 1.5";
  EXPECT_EQ(box_entry(half, {-3, 2.5, 0}, {1, 0, 0}), kNever);
  EXPECT_EQ(box_entry(half, {4, 0, 0}, {1, 0, 0}), kNever) << "behind";
  EXPECT_EQ(box_entry(half, {0, 0, 0}, {1, 0, 0}), kNever) << "from inside";
}

TEST(RayEntryTest, CylinderSideAndCaps) {
  const Eigen::Vector3d half(0.5, 0.5, 1);
  EXPECT_DOUBLE_EQ(cylinder_entry(half, {-3, 0.3, 0.7}, {1, 0, 0}), 2.6) << "side";
  EXPECT_DOUBLE_EQ(cylinder_entry(half, {0.2, 0.3, 4}, {0, 0, -1}), 3) << "cap, along the axis";
  EXPECT_DOUBLE_EQ(cylinder_entry(half, {-1, 0, 2.5}, {0.6, 0, -0.8}), 1.875) << "cap, x = 0.125";
  EXPECT_EQ(cylinder_entry(half, {0.6, 0, 4}, {0, 0, -1}), kNever) << "past the side";
  EXPECT_EQ(cylinder_entry(half, {-3, 0, 1.1}, {1, 0, 0}), kNever) << "over the cap";
  EXPECT_EQ(cylinder_entry(half, {0, 0, 0}, {0, 1, 0}), kNever) << "from inside";
}

TEST(RayEntryTest, EntersOnTheSurfaceAndNoEarlier) {
  Random random(3);
  int hits = 0;
  for (const Solid::Shape shape : kShapes) {
    for (int i = 0; i < 3000; ++i) {
      const Solid solid = random_solid(shape, 1, random);
      const Eigen::Vector3d origin = random_vector(4, random);
      const Eigen::Vector3d direction = (random_vector(1, random) - origin).normalized();
      const double at = entry(solid, origin, direction);
      // Steps along the ray: the first one inside comes right after the entry.
      double first_inside = kNever;
      for (double t = 0; t < 9 && first_inside == kNever; t += 0.01) {
        if (solid.contains(origin + t * direction)) first_inside = t;
      }
      if (first_inside == 0) {
        EXPECT_EQ(at, kNever) << "from inside";
      } else if (first_inside != kNever) {
        EXPECT_LE(at, first_inside + 1e-9);
        EXPECT_GE(at, first_inside - 0.01 - 1e-9);
        ++hits;
      } else if (at != kNever) {
        EXPECT_FALSE(solid.contains(origin + (at + 0.01) * direction)) << "a corner cut at most";
      }
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(LidarCasterTest, RangesAreThoseOfASphereAhead) {
  const Solid sphere = upright(Solid::Shape::kSphere, {4, 0, 0}, Eigen::Vector3d::Constant(1));
  const LidarModel model = exact_lidar();
  const CastResult result = cast(model, {}, {object_of(sphere)});
  const BeamTable beams(model);
  std::size_t hits = 0;
  for (std::size_t channel = 0; channel < 16; ++channel) {
    for (std::size_t firing = 0; firing < 1024; ++firing) {
      // Ray at angle a to the x axis: range 4 cos a - sqrt(0.5^2 - (4 sin a)^2).
      const double cosine = beams.direction(channel, firing).x();
      const double discriminant = 0.25 - 16 * (1 - cosine * cosine);
      const std::uint16_t quanta = result.image.ranges[channel * 1024 + firing];
      if (cosine < 0 || discriminant < 0) {
        EXPECT_EQ(quanta, 0);
      } else {
        EXPECT_NEAR(quanta * 0.002, 4 * cosine - std::sqrt(discriminant), 0.001 + 1e-9);
        ++hits;
      }
    }
  }
  EXPECT_EQ(result.hits.size(), hits);
  EXPECT_GT(hits, 100u);
  for (const ldm::Point& hit : result.hits)
    EXPECT_NEAR((hit - ldm::Point(4, 0, 0)).norm(), 0.5, 1e-6);
}

TEST(LidarCasterTest, WindowsLoseNoHit) {
  const LidarModel model = exact_lidar();
  LidarCaster caster(model);
  Random random(11);
  RangeImage image;
  std::vector<ldm::Point> hits;
  std::size_t seen = 0;
  for (int i = 0; i < 150; ++i) {
    const Solid solid = random_solid(kShapes[i % 3], i % 2 == 0 ? 1 : 5, random);
    const ldm::Pose pose{random_rotation(random), random_vector(2, random)};
    if (solid.contains(pose.translation)) continue;
    caster.cast(pose, {object_of(solid)}, 1, image, hits);
    for (std::size_t ray = 0; ray < image.ranges.size(); ++ray) {
      const Eigen::Vector3d direction =
          pose.rotation * caster.beams().direction(ray / 1024, ray % 1024);
      const double range = entry(solid, pose.translation, direction);
      if (image.ranges[ray] == 0) {
        EXPECT_FALSE(range > 0.301 && range < 99) << "ray " << ray << " of solid " << i;
      } else {
        EXPECT_NEAR(image.ranges[ray] * 0.002, range, 0.001 + 1e-9);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 10000u);
}

TEST(LidarCasterTest, WindowsSpareMostRays) {
  const LidarCaster caster(exact_lidar());
  const Solid box = upright(Solid::Shape::kBox, {-4, 0, 0}, {0.5, 0.5, 1});
  const RayWindow window = caster.window({}, box);
  // Half the width at the near face, 3.75 m away, over the seam where firings begin.
  const double half_width = std::atan2(0.25, 3.75) / (2 * std::numbers::pi / 1024);
  EXPECT_EQ(window.firings, 2 * static_cast<std::size_t>(half_width) + 1);
  EXPECT_EQ(window.firing_begin, 1024 - static_cast<std::size_t>(half_width));
  EXPECT_GT(window.channel_begin, 0u);
  EXPECT_LT(window.channel_end, 16u);
}

TEST(LidarCasterTest, TheNearestSolidHidesTheOther) {
  const Solid near = upright(Solid::Shape::kBox, {2, 0, 0}, {1, 1, 1});
  const Solid far = upright(Solid::Shape::kSphere, {5, 0, 0}, Eigen::Vector3d::Constant(1));
  const CastResult alone = cast(exact_lidar(), {}, {object_of(near)});
  EXPECT_EQ(cast(exact_lidar(), {}, {object_of(near), object_of(far)}).image.ranges,
            alone.image.ranges);
  EXPECT_EQ(cast(exact_lidar(), {}, {object_of(far), object_of(near)}).image.ranges,
            alone.image.ranges);
}

TEST(LidarCasterTest, LosesReturnsOutOfRange) {
  LidarModel model = exact_lidar();
  model.min_range = 1;
  model.max_range = 5;
  const auto seen = [&model](double distance) {
    const Solid box = upright(Solid::Shape::kBox, {distance, 0, 0}, {0.2, 0.5, 0.4});
    return !cast(model, {}, {object_of(box)}).hits.empty();
  };
  EXPECT_FALSE(seen(0.8));
  EXPECT_TRUE(seen(3));
  EXPECT_FALSE(seen(5.3));
}

TEST(LidarCasterTest, NoiseHasTheModelsMoments) {
  LidarModel model = exact_lidar();
  model.range_sigma = 0.05;
  // A sphere around the sensor would be seen from inside: four walls instead.
  std::vector<ObjectState> walls;
  for (const double side : {-1, 1}) {
    walls.push_back(object_of(upright(Solid::Shape::kBox, {5 * side, 0, 0}, {1, 20, 20})));
    walls.push_back(object_of(upright(Solid::Shape::kBox, {0, 5 * side, 0}, {20, 1, 20})));
  }
  const CastResult noisy = cast(model, {}, walls);
  const CastResult exact = cast(exact_lidar(), {}, walls);
  ASSERT_EQ(exact.hits.size(), 16384u);
  double sum = 0, squares = 0;
  for (std::size_t ray = 0; ray < 16384; ++ray) {
    const double error = 0.002 * (noisy.image.ranges[ray] - exact.image.ranges[ray]);
    sum += error;
    squares += error * error;
  }
  // Five standard errors of 16384 draws.
  EXPECT_NEAR(sum / 16384, 0, 5 * 0.05 / 128);
  EXPECT_NEAR(std::sqrt(squares / 16384), 0.05, 5 * 0.05 / 128 / std::numbers::sqrt2);
  ASSERT_EQ(noisy.hits.size(), exact.hits.size());
  EXPECT_EQ(noisy.hits[77], exact.hits[77]) << "hits are free of noise";
}

TEST(LidarCasterTest, NoiseBelongsToTheRay) {
  LidarModel model = exact_lidar();
  model.range_sigma = 0.05;
  const ObjectState a = object_of(upright(Solid::Shape::kBox, {3, 0, 0}, {1, 1, 1}));
  const ObjectState b = object_of(upright(Solid::Shape::kBox, {-3, 0, 0}, {1, 1, 1}));
  const auto both = cast(model, {}, {a, b}, 7).image.ranges;
  EXPECT_EQ(cast(model, {}, {b, a}, 7).image.ranges, both);
  EXPECT_NE(cast(model, {}, {a, b}, 8).image.ranges, both);
  const auto alone = cast(model, {}, {a}, 7).image.ranges;
  for (std::size_t ray = 0; ray < alone.size(); ++ray) {
    if (alone[ray] != 0) {
      EXPECT_EQ(alone[ray], both[ray]);
    }
  }
}

TEST(LidarCasterTest, RefusesModelsItCannotSimulate) {
  const auto refused = [](auto change) {
    LidarModel model = exact_lidar();
    change(model);
    EXPECT_THROW(LidarCaster{model}, ldm::InvalidInput);
  };
  refused([](LidarModel& m) { m.elevations.clear(); });
  refused([](LidarModel& m) { m.elevations = {0.1, 0}; });
  refused([](LidarModel& m) { m.azimuths = 0; });
  refused([](LidarModel& m) { m.max_range = 132; });
  refused([](LidarModel& m) { m.min_range = 101; });
  refused([](LidarModel& m) { m.range_sigma = -1; });
  refused([](LidarModel& m) { m.range_sigma = std::nan(""); });
}

}  // namespace
}  // namespace datasets
