#include "experiments/pictures/picture_axes.h"

#include <cmath>
#include <cstdio>

namespace experiments {
namespace {

using Align = PictureCanvas::Align;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Colour kText{25, 25, 25}, kGrid{170, 170, 170}, kBorder{90, 90, 90};
constexpr double kNumberSize = 17, kNameSize = 19;
constexpr double kHalfLetter = 6;  // [pixel]: from the base line to the middle of a digit

class Axes {
 public:
  Axes(const Eigen::AlignedBox3d& border, PictureCanvas& canvas)
      : border_(border), canvas_(canvas), step_(grid_step(border.sizes().maxCoeff())) {}

  void draw_grid() {
    for (const int axis : {0, 1}) draw_lines(axis);
    canvas_.box(border_, kBorder);
  }

  void draw_numbers() {
    const Vector3d camera = canvas_.camera().T_world_camera().translation;
    for (const int axis : {0, 1}) {
      draw_floor_numbers(axis, camera(1 - axis) < border_.center()(1 - axis));
    }
    draw_height();
  }

 private:
  /// Few enough lines to count [m].
  static double grid_step(double longest_edge) {
    double step = 1;
    for (const double factor : {2.0, 2.5, 2.0, 2.0, 2.5, 2.0}) {
      if (longest_edge <= 10 * step) break;
      step *= factor;
    }
    return step;
  }

  template <class Draw>
  void for_each_step(int axis, Draw&& draw_at) const {
    for (double n = std::ceil(border_.min()(axis) / step_); n * step_ <= border_.max()(axis); ++n) {
      draw_at(n * step_);
    }
  }

  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", value + 0.0);  // no "-0"
    return text;
  }

  /// Across the floor, where the axis has whole steps.
  void draw_lines(int axis) {
    for_each_step(axis, [&](double value) {
      Vector3d from = border_.min(), to = border_.min();
      from(axis) = to(axis) = value;
      to(1 - axis) = border_.max()(1 - axis);
      canvas_.line(from, to, kGrid);
    });
  }

  /// Along the nearer edge of the floor.
  void draw_floor_numbers(int axis, bool nearer_is_low) {
    const int across = 1 - axis;
    const double margin = 0.05 * border_.sizes().maxCoeff();
    const auto beside = [&](double along, double distance) {
      Vector3d p = border_.min();
      p(axis) = along;
      p(across) =
          nearer_is_low ? border_.min()(across) - distance : border_.max()(across) + distance;
      return Vector2d(canvas_.camera().pixel(p) + Vector2d(0, kHalfLetter));
    };
    for_each_step(axis, [&](double value) {
      canvas_.words(beside(value, margin), kNumberSize, number(value), Align::kCentre, kText);
    });
    const Vector2d name = beside(border_.center()(axis), 3 * margin);
    const bool leftward = name.x() < beside(border_.center()(axis), margin).x();
    canvas_.words(name, kNameSize, axis == 0 ? "x [m]" : "y [m]",
                  leftward ? Align::kRight : Align::kLeft, kText);
  }

  /// Numbers along the upright edge at the left.
  void draw_height() {
    Vector3d p = leftmost_edge();
    const auto beside = [&](double z, double up) {
      p.z() = z;
      return Vector2d(canvas_.camera().pixel(p) + Vector2d(-12, kHalfLetter - up));
    };
    for_each_step(2, [&](double value) {
      canvas_.words(beside(value, 0), kNumberSize, number(value), Align::kRight, kText);
    });
    canvas_.words(beside(border_.max().z(), 26), kNameSize, "z [m]", Align::kRight, kText);
  }

  /// Any point of the leftmost upright edge.
  Vector3d leftmost_edge() const {
    const Vector3d right = canvas_.camera().T_world_camera().rotation.col(0);
    return (right.array() < 0).select(border_.max(), border_.min());
  }

  const Eigen::AlignedBox3d& border_;
  PictureCanvas& canvas_;
  double step_;  // [m]
};

}  // namespace

void draw_grid(const Eigen::AlignedBox3d& border, PictureCanvas& canvas) {
  Axes(border, canvas).draw_grid();
}

void draw_numbers(const Eigen::AlignedBox3d& border, PictureCanvas& canvas) {
  Axes(border, canvas).draw_numbers();
}

}  // namespace experiments
