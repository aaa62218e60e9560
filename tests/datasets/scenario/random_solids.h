#pragma once
/// Solids, poses and rays drawn at random for the tests of the simulated sensor.
#include <Eigen/Geometry>

#include "datasets/frame.h"
#include "datasets/random.h"

namespace datasets {

inline Eigen::Vector3d random_vector(double reach, Random& random) {
  const double x = random.uniform(-reach, reach);
  const double y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

inline Eigen::Matrix3d random_rotation(Random& random) {
  const Eigen::Vector3d axis = random_vector(1, random);
  return Eigen::AngleAxisd(random.uniform(0, 3), axis.normalized()).toRotationMatrix();
}

/// Within `reach` of the origin along each axis, edges from 0.1 to 2 m.
inline Solid random_solid(Solid::Shape shape, double reach, Random& random) {
  Solid solid{shape, {random_rotation(random), random_vector(reach, random)}, {}};
  const double width = random.uniform(0.1, 2);
  solid.size = Eigen::Vector3d::Constant(width);
  if (shape == Solid::Shape::kBox) solid.size.y() = random.uniform(0.1, 2);
  if (shape != Solid::Shape::kSphere) solid.size.z() = random.uniform(0.1, 2);
  return solid;
}

}  // namespace datasets
