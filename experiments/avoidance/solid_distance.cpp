#include "experiments/avoidance/solid_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/avoidance/planner/surroundings.h"

namespace experiments {

double signed_distance(const datasets::Solid& solid, const Eigen::Vector3d& p) {
  const Eigen::Vector3d local =
      solid.T_world_solid.rotation.transpose() * (p - solid.T_world_solid.translation);
  const Eigen::Vector3d half = solid.size / 2;
  switch (solid.shape) {
    case datasets::Solid::Shape::kBox:
      return box_distance(local, half).value;
    case datasets::Solid::Shape::kCylinder: {
      // In the plane through the axis and the point the cylinder is a rectangle.
      const double beside = local.head<2>().norm() - half.x();
      const double above = std::abs(local.z()) - half.z();
      return std::min(std::max(beside, above), 0.0) +
             std::hypot(std::max(beside, 0.0), std::max(above, 0.0));
    }
    case datasets::Solid::Shape::kSphere:
      return local.norm() - half.x();
  }
  return std::numeric_limits<double>::infinity();
}

double signed_distance(const datasets::ObjectState& object, const Eigen::Vector3d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const datasets::Solid& solid : object.solids) {
    nearest = std::min(nearest, signed_distance(solid, p));
  }
  return nearest;
}

}  // namespace experiments
