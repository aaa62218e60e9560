#pragma once
/// What one scan shows of an object: its outline around the sensor, slice by slice (no paper
/// section; docs/objects.md).
#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace ldm {

/// Returns one above the other within a slice.
struct Column {
  Eigen::Vector2d point;  ///< mean of its returns, horizontal, world [m]
  double range;           ///< horizontal distance of `point` from the sensor [m]
  double bearing;         ///< tangent of its angle from the view's axis; grows to the left
  int returns;
};

/// Columns at about the same height, from right to left; at least one.
struct Slice {
  int level;  ///< floor(z / View::kSliceHeight), world
  std::vector<Column> columns;
  /// Whether the first and the last column are where the object ends: see Panorama::mark_edges.
  std::array<bool, 2> edges{true, true};

  double spacing() const;  ///< between columns, as difference of bearings
};

/// A view of an object from one place.
struct View {
  static constexpr double kSliceHeight = 0.4;  ///< [m]

  Eigen::Vector2d sensor = Eigen::Vector2d::Zero();  ///< world [m]
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();   ///< unit vector from the sensor to the object
  std::vector<Slice> slices;                         ///< upwards
  double right = 0, left = 0;                        ///< bearings of its ends
  double range = 0;                                  ///< mean, horizontal [m]

  Eigen::Vector2d leftwards() const { return {-axis.y(), axis.x()}; }
  double width() const { return (left - right) * range; }  ///< between its ends [m]
  /// Of the circle that both ends touch, world [m]: rough, but the same while a thing turns.
  Eigen::Vector2d centre() const;
  bool whole() const;                               ///< both ends are edges of some slice
  double distance(const Eigen::Vector2d& p) const;  ///< of p from the nearest column [m]

  /// Calls visit(column) for each.
  template <class Visit>
  void for_each_column(Visit&& visit) const {
    for (const Slice& slice : slices) {
      for (const Column& column : slice.columns) visit(column);
    }
  }
};

/// The columns of `points` (world [m], at least one), seen from `sensor`. A column is as wide as
/// the spacing of a LiDAR of 1800 firings, 15 mm, or a sixtieth of the object, whichever is most.
/// It holds its nearest return and those within 10 cm behind; level surfaces give none. Cost: n log
/// n.
/// @param slices else all is one slice
View view_of(const Eigen::Vector2d& sensor, std::span<const Eigen::Vector3d> points,
             bool slices = true);

}  // namespace ldm
