#include "experiments/avoidance/planner/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace experiments {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// One line of the transform: distance[i] = min over j of (i - j)^2 + distance[j], as the lower
/// envelope of parabolas.
class LineTransform {
 public:
  explicit LineTransform(std::size_t longest)
      : sites_(longest), bounds_(longest + 1), heights_(longest) {}

  /// @param line first of `count` values that lie `stride` apart
  void run(float* line, std::size_t count, std::size_t stride) {
    std::size_t envelope = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float height = line[i * stride];
      if (height == kFar) continue;
      const float x = static_cast<float>(i);
      float bound = -kFar;
      while (envelope > 0) {
        bound = crossing(sites_[envelope - 1], heights_[envelope - 1], x, height);
        if (bound > bounds_[envelope - 1]) break;
        --envelope;
        bound = -kFar;
      }
      sites_[envelope] = x;
      heights_[envelope] = height;
      bounds_[envelope++] = bound;
    }
    if (envelope == 0) return;
    bounds_[envelope] = kFar;
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float x = static_cast<float>(i);
      while (bounds_[at + 1] < x) ++at;
      line[i * stride] = (x - sites_[at]) * (x - sites_[at]) + heights_[at];
    }
  }

 private:
  /// Where the parabola of the site b > a comes to lie below that of a.
  static float crossing(float a, float height_a, float b, float height_b) {
    return ((height_b + b * b) - (height_a + a * a)) / (2 * (b - a));
  }

  std::vector<float> sites_, bounds_, heights_;
};

}  // namespace

void DistanceField::build(const ldm::VoxelBox& window, double resolution,
                          const std::vector<std::uint8_t>& occupied) {
  window_ = window;
  resolution_ = resolution;
  distances_.resize(window.count());
  std::transform(occupied.begin(), occupied.end(), distances_.begin(),
                 [](std::uint8_t is_occupied) { return is_occupied != 0 ? 0.F : kFar; });
  const auto nx = static_cast<std::size_t>(window.size.x());
  const auto ny = static_cast<std::size_t>(window.size.y());
  const auto nz = static_cast<std::size_t>(window.size.z());
  LineTransform transform(std::max({nx, ny, nz}));
  for (std::size_t row = 0; row < ny * nz; ++row) transform.run(&distances_[row * nx], nx, 1);
  for (std::size_t z = 0; z < nz; ++z) {
    for (std::size_t x = 0; x < nx; ++x) transform.run(&distances_[z * nx * ny + x], ny, nx);
  }
  for (std::size_t column = 0; column < nx * ny; ++column) {
    transform.run(&distances_[column], nz, nx * ny);
  }
  const auto edge = static_cast<float>(resolution), reach = static_cast<float>(reach_);
  for (float& d : distances_) d = std::min(edge * std::sqrt(d), reach);
}

Distance DistanceField::at(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d place =
      p / resolution_ - window_.origin.cast<double>() - Eigen::Vector3d::Constant(0.5);
  const Eigen::Vector3d low = place.array().floor();
  const Eigen::Array3d most = window_.size.cast<double>().array() - 2;
  if (!((low.array() >= 0).all() && (low.array() <= most).all()))
    return {reach_, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d u = place - low;
  const auto nx = static_cast<std::size_t>(window_.size.x());
  const std::size_t layer = nx * static_cast<std::size_t>(window_.size.y());
  const std::size_t first = static_cast<std::size_t>(low.x()) +
                            nx * static_cast<std::size_t>(low.y()) +
                            layer * static_cast<std::size_t>(low.z());
  const auto corner = [&](std::size_t x, std::size_t y, std::size_t z) {
    return static_cast<double>(distances_[first + x + nx * y + layer * z]);
  };
  // Along x on the four edges, then along y on two faces, then along z.
  double edge[2][2], slope[2][2];
  for (std::size_t z = 0; z < 2; ++z) {
    for (std::size_t y = 0; y < 2; ++y) {
      slope[z][y] = corner(1, y, z) - corner(0, y, z);
      edge[z][y] = corner(0, y, z) + u.x() * slope[z][y];
    }
  }
  const double face[2] = {edge[0][0] + u.y() * (edge[0][1] - edge[0][0]),
                          edge[1][0] + u.y() * (edge[1][1] - edge[1][0])};
  const auto mixed = [](double a, double b, double share) { return a + share * (b - a); };
  return {mixed(face[0], face[1], u.z()),
          Eigen::Vector3d(mixed(mixed(slope[0][0], slope[0][1], u.y()),
                                mixed(slope[1][0], slope[1][1], u.y()), u.z()),
                          mixed(edge[0][1] - edge[0][0], edge[1][1] - edge[1][0], u.z()),
                          face[1] - face[0]) /
              resolution_};
}

}  // namespace experiments
