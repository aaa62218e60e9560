#include "experiments/pictures/picture.h"

#include <algorithm>
#include <numbers>

#include "experiments/pictures/label_placer.h"
#include "experiments/pictures/picture_axes.h"
#include "experiments/pictures/picture_solids.h"

namespace experiments {
namespace {

using Align = PictureCanvas::Align;
using Eigen::Vector2d;

constexpr Colour kText{25, 25, 25};
constexpr double kLegendStep = 31, kLastLegendRow = 684;  // [pixel]

/// The words and the legend.
class Words {
 public:
  Words(const Picture& picture, PictureCanvas& canvas) : picture_(picture), canvas_(canvas) {}

  /// At the places where the picture's camera sees what they belong to.
  void draw() {
    draw_numbers(picture_.border, canvas_);
    draw_labels();
    draw_heading();
    draw_legend();
  }

 private:
  void draw_heading() {
    Vector2d at(24, 40);
    for (const std::string& line : picture_.heading) {
      const bool first = &line == &picture_.heading.front();
      canvas_.words(at, first ? 25 : 20, line, Align::kLeft, kText);
      at.y() += first ? 32 : 27;
    }
  }

  void draw_labels() {
    LabelPlacer placer;
    const Vector2d uav = canvas_.camera().pixel(picture_.T_world_uav.translation);
    placer.keep_clear({uav - Vector2d(40, 25), uav + Vector2d(40, 25)});
    for (const Picture::Arrow& arrow : picture_.arrows) placer.keep_clear(on_image(arrow));
    for (const Picture::Arrow& arrow : picture_.arrows) {
      constexpr double kSize = 19, kLetterHeight = 14;
      const Vector2d size(canvas_.width(arrow.label, kSize), kLetterHeight);
      const Eigen::AlignedBox2d place = placer.place(size, on_image(arrow));
      canvas_.words({place.min().x(), place.max().y()}, kSize, arrow.label, Align::kLeft,
                    kArrowColour);
    }
  }

  Eigen::AlignedBox2d on_image(const Picture::Arrow& arrow) const {
    Eigen::AlignedBox2d box(canvas_.camera().pixel(arrow.from.cast<double>()));
    return box.extend(canvas_.camera().pixel(arrow.to.cast<double>()));
  }

  /// Symbols are small solids between camera and map.
  void draw_legend() {
    const PictureCamera& camera = canvas_.camera();
    const double depth = 0.6 * camera.depth();
    const double pixel = depth / camera.focal_length();  // [m]
    const std::size_t rows = picture_.cube_keys.size() + (picture_.arrow_key.empty() ? 0 : 1) +
                             picture_.paths.size() + 2;
    double row = std::min(560.0, kLastLegendRow - kLegendStep * static_cast<double>(rows - 1));
    const auto at = [&](double column) { return camera.world({column, row}, depth); };
    const auto explain = [&](const std::string& text) {
      canvas_.words({100, row + 6}, 19, text, Align::kLeft, kText);
      row += kLegendStep;
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
      canvas_.arrow(at(30), at(82), 7 * pixel, kArrowColour);
      explain(picture_.arrow_key);
    }
    for (const Picture::Path& path : picture_.paths) {
      for (const double column : {34.0, 48.0, 62.0, 76.0}) {
        canvas_.ball(at(column), 4 * pixel, path.colour);
      }
      explain(path.text);
    }
    for (const double column : {34.0, 39.0, 44.0, 49.0}) canvas_.dot(at(column), kPointColour);
    for (const double column : {61.0, 66.0, 71.0, 76.0}) canvas_.dot(at(column), kOutsideColour);
    explain("LiDAR returns (outside: grey)");
    draw_uav({picture_.T_world_uav.rotation, at(55)}, 60 * pixel, canvas_);
    explain("UAV");
  }

  const Picture& picture_;
  PictureCanvas& canvas_;
};

void draw(const Picture& picture, PictureCanvas& canvas) {
  draw_solids(picture, canvas);
  Words(picture, canvas).draw();
}

}  // namespace

PictureCamera camera_of(const Picture& picture) {
  constexpr double kDegree = std::numbers::pi / 180;
  const PixelBox within{.left = 430, .right = 1240, .top = 12, .bottom = 658};  // beside the legend
  return {picture.border, within, -60 * kDegree, 25 * kDegree, 2000};
}

void write_png(const Picture& picture, datasets::PartialFile& file) {
  PictureCanvas canvas(camera_of(picture));
  draw(picture, canvas);
  canvas.write_png(file);
}

std::vector<std::uint8_t> pixels(const Picture& picture) {
  PictureCanvas canvas(camera_of(picture));
  draw(picture, canvas);
  return canvas.pixels();
}

}  // namespace experiments
