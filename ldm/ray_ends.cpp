#include "ldm/ray_ends.h"

#include <algorithm>
#include <limits>

namespace ldm {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

/// t at which o + t * d leaves [0, size], o inside.
float exit(float o, float d, float size) {
  const float t = ((d > 0 ? size : 0) - o) / d;
  return d == 0 ? kNever : t;
}

/// Truncation is floor in the box, and cheaper; rounding may have carried x across its border.
std::int32_t cell(float x, float size) {
  return static_cast<std::int32_t>(std::min(std::max(0.0F, x), size - 1));
}

}  // namespace

void RayEnds::find(std::span<const Point> rays, bool for_ever) {
  const float reach = for_ever ? kNever : 1;
  const Eigen::Vector3f size = size_.cast<float>();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const float x = rays[i].x();
    const float y = rays[i].y();
    const float z = rays[i].z();
    const float dx = turn_(0, 0) * x + turn_(0, 1) * y + turn_(0, 2) * z;
    const float dy = turn_(1, 0) * x + turn_(1, 1) * y + turn_(1, 2) * z;
    const float dz = turn_(2, 0) * x + turn_(2, 1) * y + turn_(2, 2) * z;
    const float leaves =
        std::min(exit(sensor_.x(), dx, size.x()),
                 std::min(exit(sensor_.y(), dy, size.y()), exit(sensor_.z(), dz, size.z())));
    const float t = std::min(leaves, reach);
    flag_[i] = reach < leaves ? flag::kOccupied : leaves < kNever ? flag::kFree : flag::kNone;
    x_[i] = cell(sensor_.x() + t * dx, size.x());
    y_[i] = cell(sensor_.y() + t * dy, size.y());
    z_[i] = cell(sensor_.z() + t * dz, size.z());
  }
}

}  // namespace ldm
