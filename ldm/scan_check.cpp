#include "ldm/scan_check.h"

#include <Eigen/LU>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

namespace ldm {
namespace {

constexpr double kFarthest = 1e7;  // [m]: its voxel index still fits 32 bits at 1 cm a voxel
constexpr double kSkew = 1e-3;     // how far from orthonormal a matrix of rounded numbers may be

void check_rotation(const Eigen::Matrix3d& r, std::string_view name) {
  // Nothing that is not a number is within a bound.
  const Eigen::Matrix3d skew = r.transpose() * r - Eigen::Matrix3d::Identity();
  if ((skew.array().abs() <= kSkew).all() && r.determinant() > 0) return;
  std::ostringstream message;
  message << name << ".rotation = "
          << r.format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ", "; ", "", "", "[", "]"))
          << ": allowed: a rotation matrix: orthonormal within " << kSkew << ", determinant +1";
  throw InvalidInput(message.str());
}

void check_pose(const Pose& pose, std::string_view name) {
  check_rotation(pose.rotation, name);
  const Eigen::Vector3d& t = pose.translation;
  if ((t.array().abs() <= kFarthest).all()) return;
  std::ostringstream message;
  message << name << ".translation = (" << t.x() << ", " << t.y() << ", " << t.z()
          << ") m: allowed: coordinates within +-1e7 m";
  throw InvalidInput(message.str());
}

void check_points(const std::vector<Point>& points, std::string_view name) {
  // One pass without branches decides (NaN is not within anything); the search for the culprit runs
  // only when there is one.
  const auto beyond = [](float x) { return static_cast<int>(!(std::abs(x) <= kFarthest)); };
  const auto is_bad = [&](const Point& p) { return beyond(p.x()) | beyond(p.y()) | beyond(p.z()); };
  int bad = 0;
  for (const Point& p : points) bad |= is_bad(p);
  if (bad == 0) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_bad(points[i]) == 0) continue;
    std::ostringstream message;
    message << "scan." << name << "[" << i << "] = (" << points[i].x() << ", " << points[i].y()
            << ", " << points[i].z() << "): allowed: coordinates within +-1e7 m";
    throw InvalidInput(message.str());
  }
}

}  // namespace

void check_scan(const Scan& scan, std::optional<double> previous_time) {
  if (!std::isfinite(scan.time)) {
    throw InvalidInput("scan.time = " + std::to_string(scan.time) + " s: allowed: a finite number");
  }
  if (previous_time && scan.time < *previous_time) {
    throw InvalidInput("scan.time = " + std::to_string(scan.time) +
                       " s: time goes backwards; allowed: at least " +
                       std::to_string(*previous_time) + " s, the time of the scan before");
  }
  check_pose(scan.T_world_uav, "scan.T_world_uav");
  check_pose(scan.T_world_sensor, "scan.T_world_sensor");
  check_points(scan.points, "points");
  check_points(scan.no_returns, "no_returns");
}

}  // namespace ldm
