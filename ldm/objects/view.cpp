#include "ldm/objects/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ldm {
namespace {

constexpr double kColumnAngle = 0.0035;  // [rad]
constexpr double kColumnWidth = 0.015;   // [m]
constexpr double kMostColumns = 60;      // of a slice
constexpr double kFront = 0.1;           // depth of a column [m]
constexpr double kDepthOfWidth = 0.42;   // from the middle of the front of a circle to its centre

struct Return {
  int level;
  double bearing;
  double range;
  double z;
};

std::vector<Return> returns_of(const View& view, std::span<const Eigen::Vector3d> points,
                               bool slices) {
  std::vector<Return> returns;
  returns.reserve(points.size());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector2d r = p.head<2>() - view.sensor;
    const double ahead = std::max(r.dot(view.axis), 1e-3);
    returns.push_back({slices ? static_cast<int>(std::floor(p.z() / View::kSliceHeight)) : 0,
                       r.dot(view.leftwards()) / ahead, r.norm(), p.z()});
  }
  std::sort(returns.begin(), returns.end(), [](const Return& a, const Return& b) {
    return a.level != b.level ? a.level < b.level : a.bearing < b.bearing;
  });
  return returns;
}

/// The front of `returns`, which lie within a column's angle and a slice. None if that is a line
/// which a ring of the LiDAR draws on a level surface: it stays with the sensor, whatever the
/// object does.
std::optional<Column> column_of(const View& view, std::span<const Return> returns) {
  double nearest = returns[0].range;
  for (const Return& r : returns) nearest = std::min(nearest, r.range);
  double bearing = 0, range = 0, low = returns[0].z + 1e3, high = returns[0].z - 1e3;
  int n = 0;
  for (const Return& r : returns) {
    if (r.range > nearest + kFront) continue;
    bearing += r.bearing;
    range += r.range;
    low = std::min(low, r.z);
    high = std::max(high, r.z);
    ++n;
  }
  if (returns.size() > static_cast<std::size_t>(n) && high - low < kFront) return std::nullopt;
  bearing /= n;
  range /= n;
  const Eigen::Vector2d direction = (view.axis + bearing * view.leftwards()).normalized();
  return Column{view.sensor + range * direction, range, bearing, n};
}

}  // namespace

double Slice::spacing() const {
  if (columns.size() < 2) return 2 * kColumnAngle;
  return (columns.back().bearing - columns.front().bearing) /
         static_cast<double>(columns.size() - 1);
}

bool View::whole() const {
  bool right_edge = false, left_edge = false;
  for (const Slice& slice : slices) {
    right_edge |= slice.edges[0];
    left_edge |= slice.edges[1];
  }
  return right_edge && left_edge;
}

double View::distance(const Eigen::Vector2d& p) const {
  double least = std::numeric_limits<double>::infinity();
  for_each_column([&](const Column& c) { least = std::min(least, (c.point - p).squaredNorm()); });
  return std::sqrt(least);
}

Eigen::Vector2d View::centre() const {
  const double middle = 0.5 * (left + right);
  const double quarter = 0.25 * (left - right) + 1e-9;
  double sum = 0;
  int n = 0;
  for_each_column([&](const Column& c) {
    if (std::abs(c.bearing - middle) > quarter) return;
    sum += c.returns * c.range;
    n += c.returns;
  });
  const double depth = n > 0 ? sum / n : range;
  return sensor + (depth + kDepthOfWidth * width()) * (axis + middle * leftwards()).normalized();
}

View view_of(const Eigen::Vector2d& sensor, std::span<const Eigen::Vector3d> points, bool slices) {
  View view;
  view.sensor = sensor;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : points) {
    sum += p.head<2>() - sensor;
    view.range += (p.head<2>() - sensor).norm() / static_cast<double>(points.size());
  }
  if (sum.norm() > 0) view.axis = sum.normalized();
  const std::vector<Return> returns = returns_of(view, points, slices);
  const auto [right, left] = std::minmax_element(
      returns.begin(), returns.end(), [](auto& a, auto& b) { return a.bearing < b.bearing; });
  view.right = right->bearing;
  view.left = left->bearing;

  const double widest = (view.left - view.right) / kMostColumns;
  for (std::size_t i = 0, end = 0; i < returns.size(); i = end) {
    const Return& first = returns[i];
    const double width =
        std::max({kColumnAngle, kColumnWidth / std::max(first.range, 0.1), widest});
    while (end < returns.size() && returns[end].level == first.level &&
           returns[end].bearing - first.bearing < width) {
      ++end;
    }
    const auto column = column_of(view, std::span(returns).subspan(i, end - i));
    if (!column) continue;
    if (view.slices.empty() || view.slices.back().level != first.level) {
      view.slices.push_back({.level = first.level, .columns = {}});
    }
    view.slices.back().columns.push_back(*column);
  }
  return view;
}

}  // namespace ldm
