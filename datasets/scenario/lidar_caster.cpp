#include "datasets/scenario/lidar_caster.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "datasets/random.h"
#include "datasets/scenario/ray_entry.h"

namespace datasets {
namespace {

const LidarModel& checked(const LidarModel& model) {
  const auto reject = [](const std::string& what, const std::string& allowed) {
    throw ldm::InvalidInput("lidar " + what + ": allowed: " + allowed);
  };
  const auto& elevations = model.elevations;
  if (elevations.empty() || !std::is_sorted(elevations.begin(), elevations.end())) {
    reject("elevations, " + std::to_string(elevations.size()) + " channels",
           "at least one channel, in ascending order");
  }
  if (model.azimuths < 1) reject("azimuths = " + std::to_string(model.azimuths), "at least 1");
  const double longest = 65535 * RangeImage::kQuantum;
  if (!(model.min_range >= 0 && model.min_range < model.max_range && model.max_range <= longest)) {
    reject("range = " + std::to_string(model.min_range) + " to " + std::to_string(model.max_range),
           "0 <= minimum < maximum <= " + std::to_string(longest) + " m");
  }
  if (!(model.range_sigma >= 0)) {
    reject("range_sigma = " + std::to_string(model.range_sigma), "at least 0 m");
  }
  return model;
}

/// Corners of the box around a solid in the sensor frame, around its centre there.
struct SensedBox {
  Eigen::Vector3d centre;
  Eigen::Matrix<double, 3, 8> corners;

  SensedBox(const ldm::Pose& T_world_sensor, const Solid& solid) {
    const Eigen::Matrix3d world_to_sensor = T_world_sensor.rotation.transpose();
    centre = world_to_sensor * (solid.T_world_solid.translation - T_world_sensor.translation);
    const Eigen::Matrix3d axes =
        world_to_sensor * solid.T_world_solid.rotation * (solid.size / 2).asDiagonal();
    for (int i = 0; i < 8; ++i) {
      corners.col(i) =
          centre + axes * Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
  }
};

struct AngleSpan {
  double from, to;  ///< [rad]
};

/// Azimuths that the box covers. Seen from outside its shadow on the xy plane, a convex body spans
/// less than a half turn, between two of its corners; from within, every azimuth meets it.
AngleSpan azimuth_span(const SensedBox& box) {
  const double cx = box.centre.x(), cy = box.centre.y();
  const double azimuth = std::atan2(cy, cx);
  double from = 0, to = 0;
  for (int i = 0; i < 8; ++i) {
    const double x = box.corners(0, i), y = box.corners(1, i);
    const double offset = std::atan2(cx * y - cy * x, cx * x + cy * y);
    from = std::min(from, offset);
    to = std::max(to, offset);
  }
  const bool outside = (cx != 0 || cy != 0) && to - from < std::numbers::pi - 1e-6;
  if (!outside) return {-std::numbers::pi, std::numbers::pi};
  return {azimuth + from, azimuth + to};
}

/// Elevations that hold the box: its highest and lowest corner put at the nearest or farthest
/// horizontal distance, whichever is steeper.
AngleSpan elevation_span(const SensedBox& box) {
  const auto offsets = box.corners.topRows<2>().colwise() - box.centre.head<2>();
  const double radius = std::sqrt(offsets.colwise().squaredNorm().maxCoeff());
  const double distance = box.centre.head<2>().norm();
  const double nearest = std::max(0.0, distance - radius), farthest = distance + radius;
  const double top = box.corners.row(2).maxCoeff(), bottom = box.corners.row(2).minCoeff();
  return {std::atan2(bottom, bottom < 0 ? nearest : farthest),
          std::atan2(top, top > 0 ? nearest : farthest)};
}

}  // namespace

LidarCaster::LidarCaster(const LidarModel& model) : model_(checked(model)), beams_(model) {}

RayWindow LidarCaster::window(const ldm::Pose& T_world_sensor, const Solid& solid) const {
  constexpr double kMargin = 1e-9;  // [rad] covers the rounding of the angles
  const SensedBox box(T_world_sensor, solid);
  RayWindow window;

  const AngleSpan elevation = elevation_span(box);
  const auto& channels = model_.elevations;
  const auto begin = std::lower_bound(channels.begin(), channels.end(), elevation.from - kMargin);
  const auto end = std::upper_bound(begin, channels.end(), elevation.to + kMargin);
  window.channel_begin = static_cast<std::size_t>(begin - channels.begin());
  window.channel_end = static_cast<std::size_t>(end - channels.begin());

  const AngleSpan azimuth = azimuth_span(box);
  const double step = 2 * std::numbers::pi / model_.azimuths;
  const auto first =
      static_cast<std::int64_t>(std::ceil((azimuth.from - kMargin + std::numbers::pi) / step));
  const auto last =
      static_cast<std::int64_t>(std::floor((azimuth.to + kMargin + std::numbers::pi) / step));
  const std::int64_t turn = model_.azimuths;
  window.firing_begin = static_cast<std::size_t>((first % turn + turn) % turn);
  window.firings = static_cast<std::size_t>(std::clamp<std::int64_t>(last - first + 1, 0, turn));
  return window;
}

template <class Entry>
void LidarCaster::cast_window(const RayWindow& window, const ldm::Pose& T_solid_sensor,
                              Entry entry) {
  const std::size_t turn = beams_.azimuths();
  for (std::size_t channel = window.channel_begin; channel < window.channel_end; ++channel) {
    double* const row = nearest_.data() + channel * turn;
    std::size_t firing = window.firing_begin;
    for (std::size_t i = 0; i < window.firings; ++i) {
      const Eigen::Vector3d ray = T_solid_sensor.rotation * beams_.direction(channel, firing);
      row[firing] = std::min(row[firing], entry(T_solid_sensor.translation, ray));
      if (++firing == turn) firing = 0;
    }
  }
}

void LidarCaster::cast_solid(const ldm::Pose& T_world_sensor, const Solid& solid) {
  const Eigen::Vector3d half = solid.size / 2;
  const Eigen::Matrix3d world_to_solid = solid.T_world_solid.rotation.transpose();
  const Eigen::Vector3d origin =
      world_to_solid * (T_world_sensor.translation - solid.T_world_solid.translation);
  if (origin.norm() - half.norm() > model_.max_range) return;
  const ldm::Pose T_solid_sensor{world_to_solid * T_world_sensor.rotation, origin};
  const RayWindow rays = window(T_world_sensor, solid);
  switch (solid.shape) {
    case Solid::Shape::kBox:
      return cast_window(rays, T_solid_sensor,
                         [&](const auto& o, const auto& d) { return box_entry(half, o, d); });
    case Solid::Shape::kCylinder:
      return cast_window(rays, T_solid_sensor,
                         [&](const auto& o, const auto& d) { return cylinder_entry(half, o, d); });
    case Solid::Shape::kSphere:
      return cast_window(rays, T_solid_sensor,
                         [&](const auto& o, const auto& d) { return sphere_entry(half, o, d); });
  }
}

void LidarCaster::cast(const ldm::Pose& T_world_sensor, const std::vector<ObjectState>& objects,
                       std::uint64_t noise_key, RangeImage& image,
                       std::vector<ldm::Point>& noise_free_hits) {
  const std::size_t turn = beams_.azimuths();
  nearest_.assign(beams_.channels() * turn, kNever);
  for (const ObjectState& object : objects) {
    for (const Solid& solid : object.solids) cast_solid(T_world_sensor, solid);
  }

  image.channels = static_cast<std::int32_t>(beams_.channels());
  image.azimuths = model_.azimuths;
  image.ranges.assign(nearest_.size(), 0);
  noise_free_hits.clear();
  for (std::size_t ray = 0; ray < nearest_.size(); ++ray) {
    if (nearest_[ray] > model_.max_range) continue;
    const double noise = model_.range_sigma * normal_of(random_bits(noise_key, ray));
    const double range = nearest_[ray] + noise;
    if (!(range >= model_.min_range && range <= model_.max_range)) continue;
    image.ranges[ray] = static_cast<std::uint16_t>(std::lround(range / RangeImage::kQuantum));
    if (image.ranges[ray] == 0) continue;
    const Eigen::Vector3d direction = beams_.direction(ray / turn, ray % turn);
    noise_free_hits.push_back((T_world_sensor * (nearest_[ray] * direction)).cast<float>());
  }
}

}  // namespace datasets
