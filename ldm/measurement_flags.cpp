#include "ldm/measurement_flags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ldm {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
/// [flags] A ray along an axis leaves each voxel right where the flag falls: a trace of rounding
/// must not decide which flag that is.
constexpr float kRounding = 0.01F;

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

}  // namespace

MeasurementFlags::MeasurementFlags(const MapParameters& map, NoReturnRays no_returns, bool shadows,
                                   std::int64_t threads)
    : resolution_(map.resolution),
      use_no_returns_(no_returns == NoReturnRays::kFree),
      shadows_(shadows),
      parallel_(threads),
      parts_(static_cast<std::size_t>(parallel_.parts())) {
  window_.size = map.voxels;
  // A scan ends in few of the voxels; one that ends in more of them takes more memory, once.
  const std::size_t usual_ends = std::min<std::size_t>(window_.count(), 8192);
  for (Part& part : parts_) {
    part.flags.resize(window_.count() + 1);
    part.hits.reserve(usual_ends);
    part.borders.reserve(usual_ends);
  }
}

void MeasurementFlags::mark(const Scan& scan, const VoxelBox& window) {
  window_.origin = window.origin;
  sensor_ =
      (scan.T_world_sensor.translation / resolution_ - window_.origin.cast<double>()).cast<float>();
  sensor_inside_ =
      (sensor_.array() > 0).all() && (sensor_.array() < window_.size.cast<float>().array()).all();
  R_window_sensor_ = (scan.T_world_sensor.rotation / resolution_).cast<float>();
  parallel_.for_each_part([&](int number) {
    Part& part = parts_[static_cast<std::size_t>(number)];
    std::fill(part.flags.begin(), part.flags.end(), flag::kNone);
    mark_ends(scan, number, part);
    cast(part.borders, false, part);
    cast(part.hits, true, part);
    for (const VoxelIndex& hit : part.hits) {
      part.flags[window_.index(window_.origin + hit)] = flag::kOccupied;
    }
  });
  if (parts_.size() > 1) combine();
}

/// Into the flags of the first part, the larger of all.
void MeasurementFlags::combine() {
  parallel_.for_each_part([&](int number) {
    const auto [begin, end] = parallel_.share(number, window_.count());
    std::uint8_t* const all = parts_[0].flags.data();
    for (std::size_t p = 1; p < parts_.size(); ++p) {
      const std::uint8_t* const flags = parts_[p].flags.data();
      for (std::size_t i = begin; i < end; ++i) all[i] = std::max(all[i], flags[i]);
    }
  });
}

/// Flags the voxels where rays end and lists each of them once.
void MeasurementFlags::mark_ends(const Scan& scan, int number, Part& part) const {
  part.hits.clear();
  part.borders.clear();
  mark_ends(scan.points, false, number, part);
  if (use_no_returns_) mark_ends(scan.no_returns, true, number, part);
}

void MeasurementFlags::mark_ends(std::span<const Point> rays, bool for_ever, int number,
                                 Part& part) const {
  const auto [begin, end] = parallel_.share(number, rays.size());
  RayEnds ends(sensor_, R_window_sensor_, window_.size);
  for (std::size_t first = begin; first < end; first += RayEnds::kMost) {
    const auto block = rays.subspan(first, std::min(RayEnds::kMost, end - first));
    if (!sensor_inside_) {
      for (const Point& ray : block) mark_end_from_outside(R_window_sensor_ * ray, for_ever, part);
      continue;
    }
    ends.find(block, for_ever);
    for (std::size_t i = 0; i < block.size(); ++i) {
      end_in(ends.index(i), ends.flag(i), part);
    }
  }
}

/// A ray may come into the map from outside, and may go on beyond it.
void MeasurementFlags::mark_end_from_outside(const Eigen::Vector3f& direction, bool for_ever,
                                             Part& part) const {
  const Eigen::Vector3f size = window_.size.cast<float>();
  const Eigen::Array3f end = (sensor_ + direction).array();
  if (!for_ever && (end >= 0).all() && (end < size.array()).all()) {
    return end_in(window_.index(window_.origin + end.cast<int>().matrix()), flag::kOccupied, part);
  }
  const Stretch inside = clip(sensor_, direction, size);
  if (!(inside.first < std::min(inside.last, for_ever ? kNever : 1))) return;
  const VoxelIndex border = voxel_inside(sensor_ + inside.last * direction, window_.size);
  end_in(window_.index(window_.origin + border), flag::kFree, part);
}

/// Flags the voxel and lists it.
void MeasurementFlags::first_end_in(std::size_t index, std::uint8_t flag, Part& part) const {
  part.flags[index] = flag;
  (flag == flag::kOccupied ? part.hits : part.borders)
      .push_back(window_.voxel(index) - window_.origin);
}

/// One ray through the centre of each voxel: free before it and, after a hit, shadow. Four rays are
/// on their way at a time; where one arrives, the next begins.
///
/// Free is written without a look at the flag it replaces, so no ray waits for another that has
/// just crossed the same voxel. The hits among them are written again in the end.
void MeasurementFlags::cast(std::span<const VoxelIndex> ends, bool hit, Part& part) const {
  constexpr int kForEver = std::numeric_limits<int>::max();
  std::uint8_t* const flags = part.flags.data();
  VoxelWalks walks;
  std::array<int, VoxelWalks::kLanes> left = {};  // steps of each walk
  auto end = ends.begin();
  const auto begin_next = [&](int lane) {
    if (end == ends.end()) {
      walks.set(lane, VoxelWalk(window_.count()));
      return kForEver;
    }
    const std::optional<FreeRay> ray = ray_to(*end);
    if (ray) walks.set(lane, ray->walk);
    if (ray && hit && shadows_) cast_shadow(*ray, *end, part);
    ++end;
    return ray ? ray->steps.sum() : 0;
  };
  for (;;) {
    for (int lane = 0; lane < VoxelWalks::kLanes; ++lane) {
      while (left[lane] == 0) left[lane] = begin_next(lane);
    }
    const int steps = *std::min_element(left.begin(), left.end());
    if (steps == kForEver) break;
    for (int step = 0; step < steps; ++step) {
      for (int lane = 0; lane < VoxelWalks::kLanes; ++lane) flags[walks.index(lane)] = flag::kFree;
      walks.step();
    }
    for (int& n : left) {
      if (n != kForEver) n -= steps;
    }
  }
}

/// The ray from the sensor to the centre of `end`; none if there is nothing to cross.
std::optional<MeasurementFlags::FreeRay> MeasurementFlags::ray_to(const VoxelIndex& end) const {
  const Eigen::Vector3f direction = end.cast<float>().array() + 0.5F - sensor_.array();
  const Stretch inside = clip(sensor_, direction, window_.size.cast<float>());
  if (!(inside.first < 1)) return {};    // the sensor sits outside the map, the voxel on its border
  if (inside.last == kNever) return {};  // in the very middle of the voxel: no direction
  const VoxelIndex start = voxel_inside(sensor_ + inside.first * direction, window_.size);
  // The centre is half a voxel from the walls of `end`: rounding cannot carry a wall across t = 1.
  return FreeRay{direction, VoxelWalk(sensor_, direction, inside.last, start, window_.size),
                 (end - start).cwiseAbs()};
}

/// On from `end`, where the ray arrives, to the border.
void MeasurementFlags::cast_shadow(const FreeRay& ray, const VoxelIndex& end, Part& part) const {
  const float flags_per_t = ray.direction.norm() * flag::kStepsPerVoxel;
  VoxelWalk walk = ray.walk.after(ray.steps);
  float t = walk.leaves_at();
  BorderAhead border(ray.direction, end, window_.size);
  while (border.inside_after(walk.step())) {
    const float behind = std::min((t - 1) * flags_per_t + kRounding, float{flag::kShadow - 1});
    std::uint8_t& f = part.flags[walk.index()];
    f = std::max(f, static_cast<std::uint8_t>(flag::kShadow - static_cast<int>(behind)));
    t = walk.leaves_at();
  }
}

}  // namespace ldm
