#include "ldm/measurement_flags.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ldm {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

/// The stretch [first, last] of origin + t * direction, t >= 0, inside the box [0, size].
struct Stretch {
  float first;
  float last;
};

Stretch clip(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
             const Eigen::Vector3f& size) {
  Stretch stretch{0, kNever};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (origin[axis] < 0 || origin[axis] >= size[axis]) return {1, 0};
      continue;
    }
    const float inverse = 1 / direction[axis];
    const float at_low = -origin[axis] * inverse;
    const float at_high = (size[axis] - origin[axis]) * inverse;
    stretch.first = std::max(stretch.first, std::min(at_low, at_high));
    stretch.last = std::min(stretch.last, std::max(at_low, at_high));
  }
  return stretch;
}

/// The voxel of p, or the one nearest to it. Truncation is floor in the box, and cheaper.
VoxelIndex voxel_inside(const Eigen::Vector3f& p, const Eigen::Vector3i& size) {
  return p.cast<int>().cwiseMax(0).cwiseMin((size.array() - 1).matrix());
}

/// t at which origin + t * direction leaves the box [0, size] that the origin lies in.
float exit_of(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
              const Eigen::Vector3f& size) {
  float t = kNever;
  for (int axis = 0; axis < 3; ++axis) {
    const float wall = direction[axis] > 0 ? size[axis] : 0;
    const float at = (wall - origin[axis]) / direction[axis];
    t = direction[axis] != 0 && at < t ? at : t;
  }
  return t;
}

/// Visits voxel after voxel along a ray (Amanatides and Woo, 1987), by linear index and by the
/// parameter t at which each is entered.
class Walk {
 public:
  /// From `start` (a point) in `voxel`; the ray is start + t * direction beyond t0.
  Walk(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, const VoxelIndex& voxel,
       const Eigen::Vector3i& size) {
    const int stride[3] = {1, size.x(), size.x() * size.y()};
    index_ = voxel.x() + stride[1] * voxel.y() + stride[2] * voxel.z();
    for (int axis = 0; axis < 3; ++axis) {
      const bool up = direction[axis] > 0;
      const float wall = static_cast<float>(voxel[axis] + (up ? 1 : 0));
      const bool moves = direction[axis] != 0;
      step_[axis] = up ? stride[axis] : -stride[axis];
      left_[axis] = up ? size[axis] - 1 - voxel[axis] : voxel[axis];
      between_[axis] = moves ? std::abs(1 / direction[axis]) : kNever;
      next_[axis] = moves ? (wall - origin[axis]) / direction[axis] : kNever;
    }
  }

  std::size_t index() const { return static_cast<std::size_t>(index_); }
  /// t at which the present voxel is left.
  float leaves_at() const { return std::min({next_[0], next_[1], next_[2]}); }
  /// Step into the next voxel; false if that lies outside the box.
  bool advance() {
    const int axis =
        next_[0] <= next_[1] ? (next_[0] <= next_[2] ? 0 : 2) : (next_[1] <= next_[2] ? 1 : 2);
    if (left_[axis]-- == 0) return false;
    index_ += step_[axis];
    next_[axis] += between_[axis];
    return true;
  }

 private:
  int index_;
  int step_[3];
  int left_[3];  // voxels to the border of the box
  float between_[3];
  float next_[3];
};

}  // namespace

MeasurementFlags::MeasurementFlags(const MapParameters& map, NoReturnRays no_returns, bool shadows,
                                   std::int64_t threads)
    : resolution_(map.resolution),
      use_no_returns_(no_returns == NoReturnRays::kFree),
      shadows_(shadows),
      parallel_(threads),
      parts_(static_cast<std::size_t>(parallel_.parts())) {
  window_.size = map.voxels;
  for (Part& part : parts_) part.flags.resize(window_.count());
}

void MeasurementFlags::mark(const Scan& scan, const VoxelBox& window) {
  window_.origin = window.origin;
  sensor_ =
      (scan.T_world_sensor.translation / resolution_ - window_.origin.cast<double>()).cast<float>();
  sensor_inside_ =
      (sensor_.array() > 0).all() && (sensor_.array() < window_.size.cast<float>().array()).all();
  parallel_.run([&](int number) {
    Part& part = parts_[static_cast<std::size_t>(number)];
    std::fill(part.flags.begin(), part.flags.end(), flag::kNone);
    mark_ends(scan, number, part);
    for (const VoxelIndex& voxel : part.borders) cast(voxel, false, part);
    for (const VoxelIndex& voxel : part.hits) cast(voxel, true, part);
  });
  if (parts_.size() > 1) combine();
}

/// Into the flags of the first part, the larger of all.
void MeasurementFlags::combine() {
  parallel_.run([&](int number) {
    const auto [begin, end] = parallel_.share(number, parts_[0].flags.size());
    std::uint8_t* const all = parts_[0].flags.data();
    for (std::size_t p = 1; p < parts_.size(); ++p) {
      const std::uint8_t* const some = parts_[p].flags.data();
      for (std::size_t i = begin; i < end; ++i) all[i] = std::max(all[i], some[i]);
    }
  });
}

/// Flags the voxels where rays end and lists each of them once.
void MeasurementFlags::mark_ends(const Scan& scan, int number, Part& part) const {
  part.hits.clear();
  part.borders.clear();
  const Eigen::Matrix3f turn = (scan.T_world_sensor.rotation / resolution_).cast<float>();
  const Eigen::Array3f size = window_.size.cast<float>();
  const Parallel::Share points = parallel_.share(number, scan.points.size());
  for (std::size_t i = points.begin; i < points.end; ++i) {
    const Eigen::Vector3f direction = turn * scan.points[i];
    const Eigen::Array3f q = (sensor_ + direction).array();
    if ((q < 0).any() || (q >= size).any()) {
      leave(direction, 1, part);
    } else {
      end_in(q.cast<int>(), flag::kOccupied, part);
    }
  }
  if (!use_no_returns_) return;
  const Parallel::Share rays = parallel_.share(number, scan.no_returns.size());
  for (std::size_t i = rays.begin; i < rays.end; ++i) {
    leave(turn * scan.no_returns[i], kNever, part);
  }
}

/// A ray of length `reach` * direction that goes beyond the map ends where it leaves it.
void MeasurementFlags::leave(const Eigen::Vector3f& direction, float reach, Part& part) const {
  const Eigen::Vector3f size = window_.size.cast<float>();
  float t = kNever;
  if (sensor_inside_) {
    t = exit_of(sensor_, direction, size);
  } else if (const Stretch inside = clip(sensor_, direction, size);
             inside.first < std::min(inside.last, reach)) {
    t = inside.last;
  }
  if (t == kNever) return;
  end_in(voxel_inside(sensor_ + t * direction, window_.size), flag::kFree, part);
}

/// Flags a voxel in which a ray ends and, the first time, lists it.
void MeasurementFlags::end_in(const VoxelIndex& voxel, std::uint8_t flag, Part& part) const {
  std::uint8_t& f = part.flags[window_.index(window_.origin + voxel)];
  if (f >= flag) return;
  f = flag;
  (flag == flag::kOccupied ? part.hits : part.borders).push_back(voxel);
}

/// The ray from the sensor through the centre of `end`: free before it and, after a hit, shadow.
void MeasurementFlags::cast(const VoxelIndex& end, bool hit, Part& part) const {
  const Eigen::Vector3f direction = end.cast<float>().array() + 0.5F - sensor_.array();
  const Stretch inside = clip(sensor_, direction, window_.size.cast<float>());
  if (!(inside.first < 1)) return;  // the sensor sits outside the map, the voxel on its border
  Walk walk(sensor_, direction, voxel_inside(sensor_ + inside.first * direction, window_.size),
            window_.size);
  // The centre is half a voxel from the walls of `end`: rounding cannot carry a wall across t = 1.
  float t = walk.leaves_at();
  while (t < 1) {
    part.raise(walk.index(), flag::kFree);
    if (!walk.advance()) return;
    t = walk.leaves_at();
  }
  // In the very middle of the voxel that it hits, the sensor sees no direction.
  if (!hit || !shadows_ || t == kNever) return;
  const float steps = direction.norm() * flag::kStepsPerVoxel;
  while (walk.advance()) {
    const float behind = std::min((t - 1) * steps, float{flag::kShadow - 1});
    part.raise(walk.index(), static_cast<std::uint8_t>(flag::kShadow - static_cast<int>(behind)));
    t = walk.leaves_at();
  }
}

}  // namespace ldm
