#pragma once
/// Where a ray enters a solid, in closed form (the simulated sensor of paper Sec. 4.1.1).
///
/// Rays are given in the solid's own frame. The answer is the distance in units of |direction|, or
/// infinity if the ray misses the solid, points away from it, or begins inside it.
#include <cmath>
#include <limits>

#include "datasets/frame.h"

namespace datasets {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Part of a ray, in units of its direction.
struct RaySpan {
  double from = -kNever;
  double to = kNever;

  /// Keep what lies in |x| <= half, for a coordinate x = origin + t direction.
  /// A ray within a face's plane divides 0 by 0: comparisons with NaN leave the span as it is.
  void clip(double origin, double direction, double half) {
    const double t1 = (-half - origin) / direction;
    const double t2 = (half - origin) / direction;
    const double lower = t2 < t1 ? t2 : t1;
    const double upper = t2 < t1 ? t1 : t2;
    if (from < lower) from = lower;
    if (upper < to) to = upper;
  }
  double entry() const { return from <= to && from > 0 ? from : kNever; }
};

inline double box_entry(const Eigen::Vector3d& half, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction) {
  RaySpan span;
  span.clip(origin.x(), direction.x(), half.x());
  span.clip(origin.y(), direction.y(), half.y());
  span.clip(origin.z(), direction.z(), half.z());
  return span.entry();
}

inline double cylinder_entry(const Eigen::Vector3d& half, const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& direction) {
  const double a = direction.head<2>().squaredNorm();
  const double b = origin.head<2>().dot(direction.head<2>());
  const double c = origin.head<2>().squaredNorm() - half.x() * half.x();
  const double discriminant = b * b - a * c;
  // Along the axis (a = 0) the ray is within the side for ever or never.
  if (discriminant < 0 || (a == 0 && c > 0)) return kNever;
  RaySpan span;
  if (a > 0) {
    const double root = std::sqrt(discriminant);
    span = {(-b - root) / a, (-b + root) / a};
  }
  span.clip(origin.z(), direction.z(), half.z());
  return span.entry();
}

/// Requires a direction of length 1.
inline double sphere_entry(const Eigen::Vector3d& half, const Eigen::Vector3d& origin,
                           const Eigen::Vector3d& direction) {
  const double b = origin.dot(direction);
  const double c = origin.squaredNorm() - half.x() * half.x();
  const double discriminant = b * b - c;
  if (discriminant < 0) return kNever;
  const double root = std::sqrt(discriminant);
  return RaySpan{-b - root, -b + root}.entry();
}

}  // namespace datasets
