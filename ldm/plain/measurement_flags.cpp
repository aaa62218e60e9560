#include "ldm/plain/measurement_flags.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "ldm/plain/ray.h"

namespace ldm::plain {
namespace {

using Kind = VoxelFlag::Kind;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The flag grid while it is being drawn; positions in voxels from the window's lowest corner.
class FlagGrid {
 public:
  FlagGrid(const Eigen::Vector3d& sensor, const Eigen::Vector3i& size, double resolution)
      : sensor_(sensor),
        box_{VoxelIndex::Zero(), size},
        resolution_(resolution),
        flags_(box_.count()) {}

  /// A ray returned at sensor + direction.
  void add_return(const Eigen::Vector3d& direction) {
    const Eigen::Array3d end = (sensor_ + direction).array().floor();
    if ((end < 0).any() || (end >= box_.size.cast<double>().array()).any()) {
      return add_exit({sensor_, direction, 0, 1});
    }
    flags_[box_.index(end.cast<int>())].kind = Kind::kOccupied;
  }

  /// A ray did not return.
  void add_no_return(const Eigen::Vector3d& direction) {
    add_exit({sensor_, direction, 0, kInfinity});
  }

  /// Casts one ray to each voxel flagged so far.
  std::vector<VoxelFlag> cast_all() {
    const std::vector<VoxelFlag> ends = flags_;
    for_each_voxel(box_, [&](const VoxelIndex& voxel, std::size_t i) {
      const Kind kind = ends[i].kind;
      if (kind != Kind::kNone) cast(voxel, kind == Kind::kOccupied);
    });
    return std::move(flags_);
  }

 private:
  std::optional<Passage> through_map(const Ray& ray) const {
    return passage(ray, Eigen::Vector3d::Zero(), box_.size.cast<double>());
  }

  /// The ray leaves the map; one that ends before it comes to the map does not.
  void add_exit(const Ray& ray) {
    const auto inside = through_map(ray);
    if (!inside || inside->enter == inside->leave || inside->leave == kInfinity) return;
    VoxelFlag& flag = flags_[box_.index(voxel_at(ray.direction, inside->leave))];
    if (flag.kind != Kind::kOccupied) flag.kind = Kind::kFree;
  }

  VoxelIndex voxel_at(const Eigen::Vector3d& direction, double t) const {
    const Eigen::Vector3d p = sensor_ + t * direction;
    return p.array().floor().cast<int>().max(0).min(box_.size.array() - 1);
  }

  /// Walks from voxel to voxel, always through the wall that is met first (Amanatides and Woo).
  void cast(const VoxelIndex& end, bool hit) {
    const Eigen::Vector3d direction = ray_to_centre(sensor_, end).direction;
    const auto inside = through_map({sensor_, direction, 0, kInfinity});
    if (!inside || inside->leave == kInfinity) return;  // the sensor sits in the centre of `end`
    double entered = inside->enter;
    for (VoxelIndex voxel = voxel_at(direction, entered); box_.contains(voxel);) {
      const auto [wall, left] = next_wall(direction, voxel);
      if (left < 1) {
        mark_free(voxel);
      } else if (entered > 1) {
        if (!hit) return;
        mark_shadow(voxel, (entered - 1) * direction.norm() * resolution_);
      }
      voxel[wall] += direction[wall] > 0 ? 1 : -1;
      entered = left;
    }
  }

  struct Wall {
    int axis;
    double t;
  };
  Wall next_wall(const Eigen::Vector3d& direction, const VoxelIndex& voxel) const {
    Wall next{0, kInfinity};
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0) continue;
      const double wall = voxel[axis] + (direction[axis] > 0 ? 1 : 0);
      const double t = (wall - sensor_[axis]) / direction[axis];
      if (t < next.t) next = {axis, t};
    }
    return next;
  }

  void mark_free(const VoxelIndex& voxel) {
    VoxelFlag& flag = flags_[box_.index(voxel)];
    if (flag.kind != Kind::kOccupied) flag.kind = Kind::kFree;
  }
  void mark_shadow(const VoxelIndex& voxel, double behind) {
    VoxelFlag& flag = flags_[box_.index(voxel)];
    if (flag.kind == Kind::kNone || (flag.kind == Kind::kShadow && behind < flag.behind)) {
      flag = {Kind::kShadow, behind};
    }
  }

  Eigen::Vector3d sensor_;
  VoxelBox box_;
  double resolution_;
  std::vector<VoxelFlag> flags_;
};

}  // namespace

std::vector<VoxelFlag> flag_voxels(const Scan& scan, const VoxelBox& window, double resolution,
                                   bool use_no_returns) {
  const Pose& sensor = scan.T_world_sensor;
  FlagGrid grid(sensor.translation / resolution - window.origin.cast<double>(), window.size,
                resolution);
  const auto in_voxels = [&](const Point& p) -> Eigen::Vector3d {
    return sensor.rotation * p.cast<double>() / resolution;
  };
  for (const Point& p : scan.points) grid.add_return(in_voxels(p));
  if (use_no_returns) {
    for (const Point& direction : scan.no_returns) grid.add_no_return(in_voxels(direction));
  }
  return grid.cast_all();
}

}  // namespace ldm::plain
