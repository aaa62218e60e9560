#include "experiments/method/map_check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ldm/machine/processor.h"

namespace experiments {
namespace {

struct Place {
  std::string_view method;
  std::int64_t frame;
};

template <class Value>
[[noreturn]] void refuse(const Place& place, const std::string& field, const Value& value,
                         const std::string& allowed) {
  std::ostringstream message;
  message << place.method << ", frame " << place.frame << ": " << field << " = " << value
          << ": allowed: " << allowed;
  throw std::runtime_error(message.str());
}

std::string at(const char* array, std::size_t i) {
  return std::string(array) + '[' + std::to_string(i) + ']';
}

template <class Vector>
std::string text_of(const Vector& v) {
  std::ostringstream text;
  text << '(' << v.x() << ", " << v.y() << ", " << v.z() << ')';
  return text.str();
}

void check_shape(const ldm::LocalMap& map, const Place& place) {
  constexpr int kMostVoxels = 4096;
  constexpr int kFarthest = 2'000'000'000;  // the other end of the window is an int, too
  const ldm::VoxelBox& window = map.window;
  if (!((window.size.array() >= 1).all() && (window.size.array() <= kMostVoxels).all())) {
    refuse(place, "map.window.size", text_of(window.size), "1 to 4096 voxels along each axis");
  }
  if (!((window.origin.array() >= -kFarthest).all() &&
        (window.origin.array() <= kFarthest).all())) {
    refuse(place, "map.window.origin", text_of(window.origin), "within +-2e9 voxels");
  }
  if (!(map.resolution > 0 && std::isfinite(map.resolution))) {
    refuse(place, "map.resolution", map.resolution, "a number above 0");
  }
  const std::string length = std::to_string(window.count()) + ", the voxels of the window";
  if (map.occupancy.size() != window.count()) {
    refuse(place, "length of map.occupancy", map.occupancy.size(), length);
  }
  if (map.labels.size() != window.count()) {
    refuse(place, "length of map.labels", map.labels.size(), length);
  }
}

/// The highest bit is set if a value may be bad: an occupancy outside [0, 1] or -0, a label that is
/// neither -1 nor a position in the clusters. As whole numbers, for floats from 0 on are in the
/// order of their bits: x is in 0..n if neither x nor n - x has the highest bit. One pass without
/// branches over both.
LDM_TARGET_CLONES std::uint32_t suspicion(std::span<const float> occupancy,
                                          std::span<const std::int32_t> labels,
                                          std::uint32_t clusters) {
  constexpr auto kOne = std::bit_cast<std::uint32_t>(1.0F);
  std::uint32_t of_occupancy = 0, of_labels = 0;
  for (std::size_t i = 0; i < occupancy.size(); ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(occupancy[i]);
    of_occupancy |= bits | (kOne - bits);
    const std::uint32_t number = static_cast<std::uint32_t>(labels[i]) + 1;  // -1 becomes 0
    of_labels |= number | (clusters - number);
  }
  return of_occupancy | of_labels;
}

template <class Value, class Good>
void check_all(const std::vector<Value>& values, const Place& place, const char* name,
               const std::string& allowed, Good good) {
  const auto bad = std::find_if_not(values.begin(), values.end(), good);
  if (bad == values.end()) return;
  refuse(place, at(name, static_cast<std::size_t>(bad - values.begin())), *bad, allowed);
}

void check_voxels(const ldm::LocalMap& map, const Place& place) {
  const auto clusters = static_cast<std::int32_t>(map.clusters.size());
  const std::uint32_t found =
      suspicion(map.occupancy, map.labels, static_cast<std::uint32_t>(clusters));
  if (found >> 31 == 0) return;
  check_all(map.occupancy, place, "map.occupancy", "0 to 1",
            [](float p) { return p >= 0 && p <= 1; });
  const std::string labels =
      clusters == 0 ? "-1: there are no clusters"
                    : "-1 to " + std::to_string(clusters - 1) + ", the positions in map.clusters";
  check_all(map.labels, place, "map.labels", labels,
            [clusters](std::int32_t label) { return label >= -1 && label < clusters; });
}

void check_cluster(const ldm::Cluster& cluster, const std::string& name, const Place& place) {
  const auto check_vector = [&](const Eigen::Vector3f& v, const char* field, bool positive) {
    if (v.allFinite() && (!positive || (v.array() >= 0).all())) return;
    refuse(place, name + field, text_of(v),
           positive ? "finite numbers from 0 on" : "finite numbers");
  };
  check_vector(cluster.position, ".position", false);
  check_vector(cluster.size, ".size", true);
  check_vector(cluster.velocity, ".velocity", false);
  if (cluster.id < 0) refuse(place, name + ".id", cluster.id, "0 or more");
  if (!(cluster.age >= 0 && std::isfinite(cluster.age))) {
    refuse(place, name + ".age", cluster.age, "a finite number from 0 on");
  }
  const auto& covariance = cluster.velocity_covariance;
  const Eigen::Vector3f parts(covariance(0, 0), covariance(0, 1), covariance(1, 1));
  if (!parts.allFinite() || covariance(1, 0) != parts.y() || parts.x() < 0 || parts.z() < 0) {
    refuse(place, name + ".velocity_covariance", text_of(parts),
           "a symmetric matrix of finite numbers, variances from 0 on");
  }
  if (cluster.voxels < 0) refuse(place, name + ".voxels", cluster.voxels, "0 or more");
}

}  // namespace

void check_map(const ldm::LocalMap& map, std::string_view method, std::int64_t frame) {
  const Place place{method, frame};
  check_shape(map, place);
  check_voxels(map, place);
  for (std::size_t i = 0; i < map.clusters.size(); ++i) {
    check_cluster(map.clusters[i], at("map.clusters", i), place);
  }
}

}  // namespace experiments
