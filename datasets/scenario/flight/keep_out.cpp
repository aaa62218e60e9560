#include "datasets/scenario/flight/keep_out.h"

#include <cmath>

namespace datasets {

SignedDistance signed_distance(const KeepOut& keep_out, std::size_t sample,
                               const Eigen::Vector3d& p) {
  const Eigen::Vector2d offset = p.head<2>() - keep_out.centre[sample];
  const double axis_distance = offset.norm();
  Eigen::Vector3d sideways = Eigen::Vector3d::UnitX();
  if (axis_distance > 0) sideways << offset / axis_distance, 0;
  const double beside = axis_distance - keep_out.radius;

  const bool nearer_top = p.z() - keep_out.z_min > keep_out.z_max - p.z();
  const Eigen::Vector3d upright(0, 0, nearer_top ? 1 : -1);
  const double above = nearer_top ? p.z() - keep_out.z_max : keep_out.z_min - p.z();

  if (beside > 0 && above > 0) {
    const double distance = std::sqrt(beside * beside + above * above);
    return {distance, (beside * sideways + above * upright) / distance};
  }
  return beside >= above ? SignedDistance{beside, sideways} : SignedDistance{above, upright};
}

std::size_t sample_count(const FlightTask& task) {
  // A duration that is a whole number of steps in decimal need not be one in binary.
  constexpr double kRounding = 1e-9;
  return 1 + static_cast<std::size_t>(task.duration / task.sample_step + kRounding);
}

}  // namespace datasets
