#include "experiments/avoidance/solid_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace experiments {
namespace {

using datasets::Solid;

Solid at(Solid::Shape shape, const Eigen::Vector3d& centre, const Eigen::Vector3d& size,
         double heading = 0) {
  return {shape,
          {Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()).toRotationMatrix(), centre},
          size};
}

TEST(SignedDistance, OfABoxFollowsItsPose) {
  const Solid box = at(Solid::Shape::kBox, {1, 0, 0}, {2, 4, 6}, std::numbers::pi / 2);
  EXPECT_NEAR(signed_distance(box, {1, 1.5, 0}), 0.5, 1e-12);  // its x edge lies along y
  EXPECT_NEAR(signed_distance(box, {3.5, 0, 0}), 0.5, 1e-12);
  EXPECT_NEAR(signed_distance(box, {1, 0, 0}), -1, 1e-12);
}

TEST(SignedDistance, OfACylinderBesideAboveAndBeyondItsRim) {
  const Solid cylinder = at(Solid::Shape::kCylinder, {0, 0, 1}, {1, 1, 2});
  EXPECT_NEAR(signed_distance(cylinder, {0.9, 1.2, 1.5}), 1.5 - 0.5, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, {0.1, 0, 2.25}), 0.25, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, {3.5, 0, 6}), 5, 1e-12);  // 3 beside, 4 above
  EXPECT_NEAR(signed_distance(cylinder, {0.4, 0, 1}), -0.1, 1e-12);
}

TEST(SignedDistance, OfAnObjectIsThatOfItsNearestSolid) {
  datasets::ObjectState object;
  object.solids = {at(Solid::Shape::kSphere, {0, 0, 0}, {2, 2, 2}),
                   at(Solid::Shape::kSphere, {5, 0, 0}, {1, 1, 1})};
  EXPECT_NEAR(signed_distance(object, {4, 0, 0}), 0.5, 1e-12);
  EXPECT_NEAR(signed_distance(object, {2, 0, 0}), 1, 1e-12);
}

}  // namespace
}  // namespace experiments
