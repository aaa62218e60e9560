#pragma once
/// The camera of a picture: where a point of the world appears (no paper section).
#include <Eigen/Geometry>

#include "ldm/types.h"

namespace experiments {

/// Part of an image: columns and rows [pixel], from the upper left corner.
struct PixelBox {
  double left = 0, right = 0, top = 0, bottom = 0;
};

/// A pinhole camera without distortion that looks down on a box from outside, as near as the whole
/// box still appears within a part of the image.
class PictureCamera {
 public:
  /// @param azimuth [rad], world: the camera stands in this direction from the box
  /// @param elevation [rad] above the horizon
  /// @param focal_length [pixel]
  PictureCamera(const Eigen::AlignedBox3d& box, const PixelBox& within, double azimuth,
                double elevation, double focal_length);

  /// Column and row [pixel] of a world point in front of the camera.
  Eigen::Vector2d pixel(const Eigen::Vector3d& world) const;
  /// The world point at that pixel, `depth` [m] before the camera.
  Eigen::Vector3d world(const Eigen::Vector2d& pixel, double depth) const;

  /// Camera axes: x right, y down, z forward.
  const ldm::Pose& T_world_camera() const { return T_world_camera_; }
  double depth() const { return depth_; }                ///< of the box's centre [m]
  double focal_length() const { return focal_length_; }  ///< [pixel]
  const Eigen::Vector2d& principal_point() const { return principal_; }  ///< [pixel]

 private:
  ldm::Pose T_world_camera_;
  double depth_ = 0;
  double focal_length_;
  Eigen::Vector2d principal_;
};

}  // namespace experiments
