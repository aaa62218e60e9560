#include "ldm/rays.h"

#include <algorithm>
#include <limits>

#include "ldm/machine/processor.h"
#include "ldm/measurement_flags.h"

namespace ldm {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

/// Truncation is floor in the box, and cheaper; rounding may have carried x across its border.
std::int32_t cell(float x, float size) {
  return static_cast<std::int32_t>(std::min(std::max(0.0F, x), size - 1));
}

}  // namespace

LDM_TARGET_CLONES void RayEnds::find(std::span<const Point> rays, bool for_ever) {
  const float reach = for_ever ? kNever : 1;
  const Eigen::Array3f size = size_.cast<float>();
  const Eigen::Array3f per_high = 1 / (size - sensor_.array());
  const Eigen::Array3f per_low = -1 / sensor_.array();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const float x = rays[i].x();
    const float y = rays[i].y();
    const float z = rays[i].z();
    const float dx = R_box_sensor_(0, 0) * x + R_box_sensor_(0, 1) * y + R_box_sensor_(0, 2) * z;
    const float dy = R_box_sensor_(1, 0) * x + R_box_sensor_(1, 1) * y + R_box_sensor_(1, 2) * z;
    const float dz = R_box_sensor_(2, 0) * x + R_box_sensor_(2, 1) * y + R_box_sensor_(2, 2) * z;
    // The wall that is reached first is the one of the largest 1/t: one division instead of three.
    // Beside a wall 1/t may be infinite, or not a number, which std::max passes over as its second.
    const float to_x = std::max(dx * per_high.x(), dx * per_low.x());
    const float to_y = std::max(dy * per_high.y(), dy * per_low.y());
    const float to_z = std::max(dz * per_high.z(), dz * per_low.z());
    const float leaves = 1 / std::max(0.0F, std::max(to_x, std::max(to_y, to_z)));
    const float t = std::min(leaves, reach);
    flag_[i] = reach < leaves ? flag::kOccupied : leaves < kNever ? flag::kFree : flag::kNone;
    const std::int32_t cell_x = cell(sensor_.x() + t * dx, size.x());
    const std::int32_t cell_y = cell(sensor_.y() + t * dy, size.y());
    const std::int32_t cell_z = cell(sensor_.z() + t * dz, size.z());
    index_[i] = cell_x + size_.x() * (cell_y + size_.y() * cell_z);
  }
}

}  // namespace ldm
