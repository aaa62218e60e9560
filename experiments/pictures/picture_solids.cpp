#include "experiments/pictures/picture_solids.h"

#include <algorithm>
#include <cmath>

#include "experiments/pictures/picture_axes.h"

namespace experiments {
namespace {

using Eigen::Vector3d;

constexpr Colour kShadow{226, 226, 226}, kUav{40, 48, 66};
constexpr double kPathRadius = 0.03;  // [m]

void draw_cubes(const Picture& picture, PictureCanvas& canvas) {
  for (const Picture::Cube& cube : picture.cubes) {
    Vector3d centre = cube.centre.cast<double>();
    canvas.cube(centre, picture.cube_edge, cube.colour);
    centre.z() = picture.border.min().z() - 0.002;  // below the lines of the grid
    canvas.square(centre, picture.cube_edge, kShadow);
  }
}

void draw_points(const Picture& picture, PictureCanvas& canvas) {
  for (const ldm::Point& point : picture.points) {
    const Vector3d p = point.cast<double>();
    canvas.dot(p, picture.border.contains(p) ? kPointColour : kOutsideColour);
  }
}

}  // namespace

void draw_uav(const ldm::Pose& T_world_uav, double scale, PictureCanvas& canvas) {
  canvas.ball(T_world_uav.translation, 0.13 * scale, kUav);
  for (const double x : {-0.21, 0.21}) {
    for (const double y : {-0.21, 0.21}) {
      const Vector3d rotor = T_world_uav * (scale * Vector3d(x, y, 0.05));
      canvas.disc({T_world_uav.rotation, rotor}, 0.15 * scale, kUav);
    }
  }
}

void draw_solids(const Picture& picture, PictureCanvas& canvas) {
  const double scale = std::sqrt(std::max(1.0, picture.border.sizes().maxCoeff() / 5));
  draw_grid(picture.border, canvas);
  draw_cubes(picture, canvas);
  draw_points(picture, canvas);
  for (const Picture::Arrow& arrow : picture.arrows) {
    canvas.arrow(arrow.from.cast<double>(), arrow.to.cast<double>(), 0.075 * scale, kArrowColour);
  }
  for (const Picture::Path& path : picture.paths) {
    for (const ldm::Point& p : path.points) {
      canvas.ball(p.cast<double>(), kPathRadius * scale, path.colour);
    }
  }
  draw_uav(picture.T_world_uav, scale, canvas);
}

}  // namespace experiments
