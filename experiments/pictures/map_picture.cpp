#include "experiments/pictures/map_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace experiments {
namespace {

/// Okabe and Ito's palette, which colour-blind readers can tell apart, without its red: arrows are
/// red.
constexpr std::array<Colour, 6> kPalette{
    {{86, 180, 233}, {230, 159, 0}, {0, 158, 115}, {204, 121, 167}, {0, 114, 178}, {240, 228, 66}}};
constexpr float kArrowTime = 1.0F;  // [s]
constexpr float kAbove = 0.15F;     // [m]
constexpr std::size_t kMostArrows = 12;

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

void add_cubes(const ldm::LocalMap& map, const std::vector<std::size_t>& colours,
               Picture& picture) {
  for_each_voxel(map.window, [&](const ldm::VoxelIndex& v, std::size_t i) {
    if (!ldm::is_occupied(map.occupancy[i])) return;
    const Eigen::Vector3d centre = (v.cast<double>().array() + 0.5) * map.resolution;
    const auto c = static_cast<std::size_t>(map.labels[i]);
    const bool followed = map.labels[i] >= 0 && map.clusters[c].id != 0;
    picture.cubes.push_back(
        {centre.cast<float>(), followed ? cluster_colour(colours[c]) : kNoClusterColour});
  });
}

/// The dynamic clusters that have an arrow: more of them hide one another.
std::vector<ldm::Cluster> largest_dynamic(const ldm::LocalMap& map) {
  std::vector<ldm::Cluster> clusters;
  std::copy_if(map.clusters.begin(), map.clusters.end(), std::back_inserter(clusters),
               [](const ldm::Cluster& c) { return c.dynamic; });
  std::stable_sort(
      clusters.begin(), clusters.end(),
      [](const ldm::Cluster& a, const ldm::Cluster& b) { return a.voxels > b.voxels; });
  if (clusters.size() > kMostArrows) clusters.resize(kMostArrows);
  return clusters;
}

/// Which object, how fast, and the standard deviation of that.
std::string arrow_label(const ldm::Cluster& cluster) {
  const double speed = static_cast<double>(cluster.velocity.norm());
  const Eigen::Vector2f way = cluster.velocity.head<2>().normalized();
  const double variance = static_cast<double>(way.dot(cluster.velocity_covariance * way));
  return formatted("%lld: %.1f +- %.1f m/s", static_cast<long long>(cluster.id), speed,
                   std::sqrt(variance));
}

void add_arrows(const ldm::LocalMap& map, Picture& picture) {
  for (const ldm::Cluster& c : largest_dynamic(map)) {
    // Above the cluster, whose cubes would hide it.
    const ldm::Point from = c.position + ldm::Point(0, 0, c.size.z() / 2 + kAbove);
    picture.arrows.push_back({from, from + kArrowTime * c.velocity, arrow_label(c)});
  }
}

void add_words(const datasets::Frame& frame, const ldm::LocalMap& map, Picture& picture) {
  picture.heading.push_back(
      formatted("t = %.1f s, frame %lld", frame.scan.time, static_cast<long long>(frame.index)));
  picture.heading.push_back(
      formatted("%zu occupied voxels of %g m", picture.cubes.size(), map.resolution));
  if (map.clusters.empty()) {
    picture.cube_keys = {{{kNoClusterColour}, "occupied voxels"}};
    return;
  }
  picture.heading.push_back(formatted("%zu clusters, %lld dynamic", map.clusters.size(),
                                      static_cast<long long>(map.dynamic_clusters())));
  picture.cube_keys = {{{kPalette[0], kPalette[1], kPalette[2]}, "occupied voxels, by cluster"}};
  const bool any_grey =
      std::any_of(picture.cubes.begin(), picture.cubes.end(),
                  [](const auto& cube) { return cube.colour == kNoClusterColour; });
  if (any_grey) picture.cube_keys.push_back({{kNoClusterColour}, "occupied, in no object"});
  picture.arrow_key =
      map.dynamic_clusters() > static_cast<std::int64_t>(kMostArrows)
          ? formatted("object: velocity of the %zu largest, motion in 1 s", kMostArrows)
          : "object: velocity, motion in 1 s";
}

}  // namespace

const std::size_t kClusterColours = kPalette.size();

Colour cluster_colour(std::size_t colour) {
  return kPalette[colour];
}

Picture picture_of(const datasets::Frame& frame, const ldm::LocalMap& map,
                   const std::vector<std::size_t>& colours, const std::string& heading) {
  Picture picture;
  picture.heading = {heading};
  const Eigen::Vector3d low = map.window.origin.cast<double>() * map.resolution;
  picture.border = {low, low + map.window.size.cast<double>() * map.resolution};
  picture.cube_edge = map.resolution;
  picture.T_world_uav = frame.scan.T_world_uav;
  for (const ldm::Point& p : frame.scan.points) {
    picture.points.push_back((frame.scan.T_world_sensor * p.cast<double>()).cast<float>());
  }
  add_cubes(map, colours, picture);
  add_arrows(map, picture);
  add_words(frame, map, picture);
  return picture;
}

}  // namespace experiments
