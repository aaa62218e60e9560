#include "datasets/solid_bounds.h"

namespace datasets {

Eigen::Vector3d half_extent(const Solid& solid) {
  const Eigen::Matrix3d& rotation = solid.T_world_solid.rotation;
  Eigen::Vector3d half = solid.size / 2;
  switch (solid.shape) {
    case Solid::Shape::kBox:
      return rotation.cwiseAbs() * half;
    case Solid::Shape::kCylinder: {
      const Eigen::Vector3d disc = rotation.leftCols<2>().rowwise().norm();
      return half.z() * rotation.col(2).cwiseAbs() + half.x() * disc;
    }
    case Solid::Shape::kSphere:
      return half;
  }
  return half;
}

}  // namespace datasets
