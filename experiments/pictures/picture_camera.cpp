#include "experiments/pictures/picture_camera.h"

#include <algorithm>
#include <cmath>

namespace experiments {

PictureCamera::PictureCamera(const Eigen::AlignedBox3d& box, const PixelBox& within, double azimuth,
                             double elevation, double focal_length)
    : focal_length_(focal_length),
      principal_(0.5 * (within.left + within.right), 0.5 * (within.top + within.bottom)) {
  const Eigen::Vector3d forward(-std::cos(elevation) * std::cos(azimuth),
                                -std::cos(elevation) * std::sin(azimuth), -std::sin(elevation));
  const Eigen::Vector3d right(-std::sin(azimuth), std::cos(azimuth), 0);
  Eigen::Matrix3d& R = T_world_camera_.rotation;
  R << right, forward.cross(right), forward;

  // A corner at (x, y, z) of the camera's axes, seen from `depth_` before the centre of the box,
  // appears at focal_length * (x, y) / (depth_ + z) from the principal point.
  const double tan_x = 0.5 * (within.right - within.left) / focal_length;
  const double tan_y = 0.5 * (within.bottom - within.top) / focal_length;
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(i);
    const Eigen::Vector3d p = R.transpose() * (box.corner(corner) - box.center());
    depth_ = std::max({depth_, std::abs(p.x()) / tan_x - p.z(), std::abs(p.y()) / tan_y - p.z()});
  }
  T_world_camera_.translation = box.center() - depth_ * forward;
}

Eigen::Vector2d PictureCamera::pixel(const Eigen::Vector3d& world) const {
  const Eigen::Vector3d p =
      T_world_camera_.rotation.transpose() * (world - T_world_camera_.translation);
  return principal_ + focal_length_ / p.z() * p.head<2>();
}

Eigen::Vector3d PictureCamera::world(const Eigen::Vector2d& pixel, double depth) const {
  const Eigen::Vector2d xy = (pixel - principal_) * depth / focal_length_;
  return T_world_camera_ * Eigen::Vector3d(xy.x(), xy.y(), depth);
}

}  // namespace experiments
