/// Measurement flags of random scans against brute force: each voxel is tested against each ray.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "ldm/measurement_flags.h"
#include "tests/ldm/random_inputs.h"
#include "tests/reference/ray_oracle.h"

namespace ldm {
namespace {

using reference::Crossing;
using reference::Ray;

/// [voxels] Single precision carries a ray this well from wall to wall.
constexpr double kTolerance = 2e-3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A scan with the voxels in which its rays end, in voxels from the window's lowest corner.
struct KnownScan {
  Scan scan;
  Eigen::Vector3d sensor;
  std::vector<VoxelIndex> hits;
  std::vector<VoxelIndex> borders;
};

class RandomScans {
 public:
  RandomScans(const VoxelBox& window, double resolution, std::uint64_t seed)
      : window_(window), resolution_(resolution), random_(seed) {}

  KnownScan draw(bool sensor_inside) {
    KnownScan known;
    const Eigen::Vector3d size = window_.size.cast<double>();
    for (int axis = 0; axis < 3; ++axis) {
      known.sensor[axis] = uniform(0.05, 0.95, random_) * size[axis];
    }
    if (!sensor_inside) known.sensor[uniform_int(0, 2, random_)] += 1.2 * size.maxCoeff();
    Pose& pose = known.scan.T_world_sensor;
    pose.rotation << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
    pose.translation = (known.sensor + window_.origin.cast<double>()) * resolution_;
    const int hits = uniform_int(0, 25, random_);
    for (int i = 0; i < hits; ++i) add_hit(known);
    for (int i = 0; i < 12; ++i) add_exit(known, i % 2 == 0);
    return known;
  }

 private:
  Point in_sensor_frame(const KnownScan& known, const Eigen::Vector3d& local) const {
    const Eigen::Vector3d ray = (local - known.sensor) * resolution_;
    return (known.scan.T_world_sensor.rotation.transpose() * ray).cast<float>();
  }
  /// A point in a voxel, away from its walls.
  Eigen::Vector3d somewhere_in(const VoxelIndex& v) {
    Eigen::Vector3d p = v.cast<double>();
    for (int axis = 0; axis < 3; ++axis) p[axis] += uniform(0.1, 0.9, random_);
    return p;
  }
  void add_hit(KnownScan& known) {
    const VoxelIndex v = random_voxel({VoxelIndex::Zero(), window_.size}, random_);
    known.hits.push_back(v);
    known.scan.points.push_back(in_sensor_frame(known, somewhere_in(v)));
  }
  /// A ray that leaves the map through one of its faces: without a return, or with one beyond.
  void add_exit(KnownScan& known, bool returns) {
    const int axis = uniform_int(0, 2, random_);
    const bool high = uniform_int(0, 1, random_) == 1;
    VoxelIndex v = random_voxel({VoxelIndex::Zero(), window_.size}, random_);
    v[axis] = high ? window_.size[axis] - 1 : 0;
    Eigen::Vector3d exit = somewhere_in(v);
    exit[axis] = high ? window_.size[axis] : 0;
    const Eigen::Vector3d ray = exit - known.sensor;
    if ((high ? ray[axis] : -ray[axis]) < 0.1 * ray.norm()) return;  // enters there, or grazes
    known.borders.push_back(v);
    if (returns) {
      known.scan.points.push_back(in_sensor_frame(known, known.sensor + 1.5 * ray));
    } else {
      known.scan.no_returns.push_back(in_sensor_frame(known, exit).normalized());
    }
  }

  VoxelBox window_;
  double resolution_;
  Random random_;
};

/// Which flags a voxel may have.
struct Allowed {
  bool occupied = false;
  Crossing crossed = Crossing::kMissed;
  Crossing shadowed = Crossing::kMissed;
  double nearest_shadow = kInfinity;  ///< from the obstacle's middle [voxels], grazing or not
  double surest_shadow = kInfinity;   ///< of the rays that do not graze

  bool admits(std::uint8_t f) const {
    if (occupied || f == flag::kOccupied) return occupied && f == flag::kOccupied;
    if (f == flag::kFree) return crossed != Crossing::kMissed;
    if (crossed == Crossing::kCrossed) return false;
    if (f == flag::kNone) return shadowed != Crossing::kCrossed;
    const double behind = flag::shadow_distance(f);
    return shadowed != Crossing::kMissed && behind <= surest_shadow + 0.01 &&
           behind >= nearest_shadow - 1 / flag::kStepsPerVoxel - 0.01;
  }
};

Allowed allowed_at(const VoxelIndex& v, const KnownScan& known) {
  Allowed allowed;
  const auto cross = [&](const VoxelIndex& end) {
    if (end == v) return;
    const Ray ray = reference::ray_to_centre(known.sensor, end);
    allowed.crossed = std::max(allowed.crossed, reference::crossing(ray, v, kTolerance));
  };
  for (const VoxelIndex& end : known.borders) {
    cross(end);
    if (end == v) allowed.crossed = Crossing::kCrossed;
  }
  for (const VoxelIndex& end : known.hits) {
    cross(end);
    if (end == v) {
      allowed.occupied = true;
      continue;
    }
    const Ray ray = reference::ray_behind(known.sensor, end);
    const Crossing crossing = reference::crossing(ray, v, kTolerance);
    if (crossing == Crossing::kMissed) continue;
    allowed.shadowed = std::max(allowed.shadowed, crossing);
    const auto behind = [&](double margin) {
      return (reference::passage(ray, v, margin)->enter - 1) * ray.direction.norm();
    };
    allowed.nearest_shadow = std::min(allowed.nearest_shadow, behind(kTolerance));
    if (crossing == Crossing::kCrossed) {
      allowed.surest_shadow = std::min(allowed.surest_shadow, behind(-kTolerance));
    }
  }
  // A ray that only grazes may still be the nearest: nothing is sure unless some ray is.
  if (allowed.surest_shadow == kInfinity) allowed.surest_shadow = allowed.nearest_shadow + 1;
  return allowed;
}

void compare(const Eigen::Vector3i& n, bool sensor_inside, std::uint64_t seed) {
  Random random(seed);
  const VoxelBox window{random_vector(-60, 30, random), n};
  RandomScans scans(window, 0.15, seed);
  MeasurementFlags flags(map_of(n), NoReturnRays::kFree, true);
  std::array<int, 4> seen{};  // none, shadow, free, occupied
  for (int i = 0; i < 6; ++i) {
    const KnownScan known = scans.draw(sensor_inside);
    flags.mark(known.scan, window);
    for_each_voxel({VoxelIndex::Zero(), n}, [&](const VoxelIndex& v, std::size_t) {
      const std::uint8_t f = flags.flags()[window.index(window.origin + v)];
      ++seen[f == flag::kNone ? 0 : f <= flag::kShadow ? 1 : f == flag::kFree ? 2 : 3];
      const Allowed allowed = allowed_at(v, known);
      ASSERT_TRUE(allowed.admits(f))
          << "scan " << i << ", voxel " << v.transpose() << ": flag " << int{f} << ", crossed "
          << static_cast<int>(allowed.crossed) << ", shadowed "
          << static_cast<int>(allowed.shadowed) << " at " << allowed.nearest_shadow << " to "
          << allowed.surest_shadow;
    });
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST(MeasurementFlagsRaysTest, SensorInTheMap) {
  std::uint64_t seed = 1;
  for (const Eigen::Vector3i& n : map_sizes()) {
    SCOPED_TRACE(testing::Message() << n.transpose());
    compare(n, true, seed++);
  }
}

TEST(MeasurementFlagsRaysTest, SensorOutsideTheMap) {
  std::uint64_t seed = 101;
  for (const Eigen::Vector3i& n : map_sizes()) {
    SCOPED_TRACE(testing::Message() << n.transpose());
    compare(n, false, seed++);
  }
}

}  // namespace
}  // namespace ldm
