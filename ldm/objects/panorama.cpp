#include "ldm/objects/panorama.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ldm {
namespace {

constexpr std::size_t kBins = 2048;
constexpr double kBinsPerQuarter = 512;          // a quarter of kBins
constexpr double kNearer = 0.1;                  // [m]: what is nearer by this hides
constexpr double kBeside[] = {1, 1.7};           // columns, of 6 mrad or more: where that is sought
constexpr double kPast = 0.3;                    // [m]: what was seen farther off was seen past
constexpr std::size_t kBlur = 2;                 // bins: a LiDAR's columns may be so far apart
constexpr double kEnd = 0.03, kEndShare = 0.05;  // [m], of the width: so near to the object's end

}  // namespace

/// By an angle that grows with the true one and takes no arc tangent.
std::size_t Panorama::bin(const Eigen::Vector2d& direction) {
  const double sum = direction.cwiseAbs().sum();
  if (sum == 0) return 0;
  const double t = direction.y() / sum;
  const double angle = direction.x() < 0 ? 2 - t : (t < 0 ? t + 4 : t);  // 0 to 4
  return static_cast<std::size_t>(angle * kBinsPerQuarter) % kBins;
}

void Panorama::fill(const Eigen::Vector2d& sensor, std::span<const Eigen::Vector3d> points) {
  sensor_ = sensor;
  nearest_.assign(kBins, std::numeric_limits<float>::infinity());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector2d d = p.head<2>() - sensor;
    float& nearest = nearest_[bin(d)];
    nearest = std::min(nearest, static_cast<float>(d.norm()));
  }
}

bool Panorama::seen_past(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d d = p - sensor_;
  const auto beyond = static_cast<float>(d.norm() + kPast);
  const std::size_t middle = bin(d) + kBins;
  for (std::size_t b = middle - kBlur; b <= middle + kBlur; ++b) {
    if (nearest_[b % kBins] < beyond) return false;
  }
  return true;
}

void Panorama::mark_edges(View& view) const {
  for (Slice& slice : view.slices) {
    for (const std::size_t side : {0, 1}) {
      const Column& last = side == 0 ? slice.columns.front() : slice.columns.back();
      const double to_end = side == 0 ? last.bearing - view.right : view.left - last.bearing;
      slice.edges[side] = to_end * last.range <= std::max(kEnd, kEndShare * view.width());
      for (const double beside : kBeside) {
        const double apart = beside * std::max(0.006, slice.spacing());
        const double bearing = last.bearing + (side == 0 ? -apart : apart);
        const Eigen::Vector2d direction = view.axis + bearing * view.leftwards();
        if (nearest(direction) < last.range - kNearer) slice.edges[side] = false;
      }
    }
  }
}

}  // namespace ldm
