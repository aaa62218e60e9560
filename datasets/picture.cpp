#include "datasets/picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/label_placer.h"
#include "datasets/picture_axes.h"
#include "datasets/picture_canvas.h"

namespace datasets {
namespace {

using Align = PictureCanvas::Align;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Colour kText{25, 25, 25}, kShadow{226, 226, 226}, kArrow{205, 0, 0}, kUav{40, 48, 66};
constexpr Colour kPoint{20, 20, 20}, kPointOutside{185, 185, 185};

/// A quadrotor, 0.8 m across for scale 1.
void draw_uav(const ldm::Pose& T_world_uav, double scale, PictureCanvas& canvas) {
  canvas.ball(T_world_uav.translation, 0.13 * scale, kUav);
  for (const double x : {-0.21, 0.21}) {
    for (const double y : {-0.21, 0.21}) {
      const Vector3d rotor = T_world_uav * (scale * Vector3d(x, y, 0.05));
      canvas.disc({T_world_uav.rotation, rotor}, 0.15 * scale, kUav);
    }
  }
}

class Drawing {
 public:
  Drawing(const Picture& picture, PictureCanvas& canvas)
      : picture_(picture),
        canvas_(canvas),
        scale_(std::sqrt(std::max(1.0, picture.border.sizes().maxCoeff() / 5))) {}

  void draw() {
    draw_axes(picture_.border, canvas_);
    draw_cubes();
    draw_points();
    draw_arrows();
    draw_uav(picture_.T_world_uav, scale_, canvas_);
    draw_heading();
    draw_legend();
  }

 private:
  void draw_cubes() {
    for (const Picture::Cube& cube : picture_.cubes) {
      Vector3d centre = cube.centre.cast<double>();
      canvas_.cube(centre, picture_.cube_edge, cube.colour);
      centre.z() = picture_.border.min().z() - 0.002;  // below the lines of the grid
      canvas_.square(centre, picture_.cube_edge, kShadow);
    }
  }

  void draw_points() {
    for (const ldm::Point& point : picture_.points) {
      const Vector3d p = point.cast<double>();
      canvas_.dot(p, picture_.border.contains(p) ? kPoint : kPointOutside);
    }
  }

  void draw_arrows() {
    LabelPlacer placer;
    const Vector2d uav = canvas_.camera().pixel(picture_.T_world_uav.translation);
    placer.keep_clear({uav - Vector2d(40, 25), uav + Vector2d(40, 25)});
    for (const Picture::Arrow& arrow : picture_.arrows) {
      canvas_.arrow(arrow.from.cast<double>(), arrow.to.cast<double>(), 0.075 * scale_, kArrow);
      placer.keep_clear(on_image(arrow));
    }
    for (const Picture::Arrow& arrow : picture_.arrows) {
      constexpr double kSize = 19, kLetterHeight = 14;
      const Vector2d size(canvas_.width(arrow.label, kSize), kLetterHeight);
      const Eigen::AlignedBox2d place = placer.place(size, on_image(arrow));
      canvas_.words({place.min().x(), place.max().y()}, kSize, arrow.label, Align::kLeft, kArrow);
    }
  }

  Eigen::AlignedBox2d on_image(const Picture::Arrow& arrow) const {
    Eigen::AlignedBox2d box(canvas_.camera().pixel(arrow.from.cast<double>()));
    return box.extend(canvas_.camera().pixel(arrow.to.cast<double>()));
  }

  void draw_heading() {
    Vector2d at(24, 40);
    for (const std::string& line : picture_.heading) {
      const bool first = &line == &picture_.heading.front();
      canvas_.words(at, first ? 25 : 20, line, Align::kLeft, kText);
      at.y() += first ? 32 : 27;
    }
  }

  /// Symbols are small solids between camera and map.
  void draw_legend() {
    const PictureCamera& camera = canvas_.camera();
    const double depth = 0.6 * camera.depth();
    const double pixel = depth / camera.focal_length();  // [m]
    double row = 560;
    const auto at = [&](double column) { return camera.world({column, row}, depth); };
    const auto explain = [&](const std::string& text) {
      canvas_.words({100, row + 6}, 19, text, Align::kLeft, kText);
      row += 31;
    };
    for (const Picture::CubeKey& key : picture_.cube_keys) {
      double column = 55 - 11.0 * static_cast<double>(key.colours.size() - 1);
      for (const Colour& colour : key.colours) {
        canvas_.cube(at(column), 13 * pixel, colour);
        column += 22;
      }
      explain(key.text);
    }
    if (!picture_.arrow_key.empty()) {
      canvas_.arrow(at(30), at(82), 7 * pixel, kArrow);
      explain(picture_.arrow_key);
    }
    for (const double column : {34.0, 39.0, 44.0, 49.0}) canvas_.dot(at(column), kPoint);
    for (const double column : {61.0, 66.0, 71.0, 76.0}) canvas_.dot(at(column), kPointOutside);
    explain("LiDAR returns (outside: grey)");
    draw_uav({picture_.T_world_uav.rotation, at(55)}, 60 * pixel, canvas_);
    explain("UAV");
  }

  const Picture& picture_;
  PictureCanvas& canvas_;
  double scale_;  // of arrows and UAV: they stay visible in a large map
};

}  // namespace

PictureCamera camera_of(const Picture& picture) {
  constexpr double kDegree = std::numbers::pi / 180;
  const PixelBox within{.left = 430, .right = 1240, .top = 12, .bottom = 658};  // beside the legend
  return {picture.border, within, -60 * kDegree, 25 * kDegree, 2000};
}

void write_png(const Picture& picture, const std::filesystem::path& file) {
  PictureCanvas canvas(camera_of(picture));
  Drawing(picture, canvas).draw();
  canvas.write_png(file);
}

}  // namespace datasets
