#pragma once
/// Shared words: points, poses, scans, voxels, clusters, with their units and frames (paper
/// Sec. 3.1).
///
/// Frames: `world` (z up, fixed), `uav` (vehicle body), `sensor` (LiDAR). `T_world_sensor` maps
/// sensor coordinates to world coordinates. Lengths in metres, times in seconds, velocities in
/// metres a second, probabilities in [0, 1].
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace ldm {

/// Bad data or a bad parameter: the message names the field, the value and what is allowed.
struct InvalidInput : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

using Point = Eigen::Vector3f;     ///< [m], frame said by its holder
using Velocity = Eigen::Vector3f;  ///< [m/s], world frame

/// A rigid transform. No member needs over-aligned memory: the layout is the same for every -march.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m]

  Eigen::Vector3d operator*(const Eigen::Vector3d& p) const { return rotation * p + translation; }
};

/// One sweep of the LiDAR, with the pose it was taken from.
struct Scan {
  double time = 0;                ///< [s], never decreasing from scan to scan
  Pose T_world_uav;               ///< the map is centred on the voxel of its translation
  Pose T_world_sensor;            ///< origin of every ray
  std::vector<Point> points;      ///< returns, sensor frame [m]
  std::vector<Point> no_returns;  ///< unit directions of the rays without a return, sensor frame
};

/// Index of a voxel of the infinite grid: voxel v covers [v, v + 1) * resolution [m], world frame.
using VoxelIndex = Eigen::Vector3i;

/// The voxel that holds world point p [m].
inline VoxelIndex voxel_at(const Eigen::Vector3d& p, double resolution) {
  return (p / resolution).array().floor().cast<int>();
}

/// A box of voxels: origin (lowest voxel) and number of voxels per axis.
struct VoxelBox {
  VoxelIndex origin = VoxelIndex::Zero();
  Eigen::Vector3i size = Eigen::Vector3i::Zero();

  /// Number of voxels in the box.
  std::size_t count() const {
    return static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
           static_cast<std::size_t>(size.z());
  }
  bool contains(const VoxelIndex& v) const {
    const VoxelIndex d = v - origin;
    return (d.array() >= 0).all() && (d.array() < size.array()).all();
  }
  /// Row-major position of v in the box, x fastest: the order of every array of `LocalMap`.
  std::size_t index(const VoxelIndex& v) const {
    const VoxelIndex d = v - origin;
    return static_cast<std::size_t>(d.x() + size.x() * (d.y() + size.y() * d.z()));
  }
  /// The voxel at a row-major position: the inverse of `index`.
  VoxelIndex voxel(std::size_t index) const {
    const auto i = static_cast<int>(index);
    return origin + VoxelIndex(i % size.x(), i / size.x() % size.y(), i / size.x() / size.y());
  }
};

/// Calls visit(v, i) for each voxel v of a box and its position i in the order of VoxelBox::index.
template <class Visit>
void for_each_voxel(const VoxelBox& box, Visit&& visit) {
  const VoxelIndex end = box.origin + box.size;
  std::size_t i = 0;
  VoxelIndex v;
  for (v.z() = box.origin.z(); v.z() < end.z(); ++v.z()) {
    for (v.y() = box.origin.y(); v.y() < end.y(); ++v.y()) {
      for (v.x() = box.origin.x(); v.x() < end.x(); ++v.x()) visit(v, i++);
    }
  }
}

/// A group of connected occupied voxels (Sec. 3.5), and the object that is seen in it: the same id
/// in every frame, through occlusions and after it touched another.
struct Cluster {
  /// From 1, never used again for another object. Clusters that are parts of one object may share
  /// it; 0: its voxels are remembered, but nothing that is followed is in them.
  std::int64_t id = 0;
  double age = 0;                        ///< since the object was first found [s]
  Point position = Point::Zero();        ///< mean of its voxels' centres, world frame [m]
  Point size = Point::Zero();            ///< extent of its voxels' bounding box [m]
  Velocity velocity = Velocity::Zero();  ///< eq. 16
  /// Of (vx, vy) [m^2/s^2]. As in Pose, the layout is the same for every -march.
  Eigen::Matrix<float, 2, 2, Eigen::DontAlign> velocity_covariance = Eigen::Matrix2f::Zero();
  std::int32_t voxels = 0;  ///< number of voxels
  std::int32_t points = 0;  ///< returns of the last scan in them, once count_points has run
  bool dynamic = false;     ///< it moves: faster than the method's threshold, and beyond chance
};

/// P(Occ) of a voxel of which nothing is known.
inline constexpr float kUnknown = 0.5F;
/// Whether a map says occupied of a voxel: above unknown, which counts as free.
inline bool is_occupied(float p) {
  return p > kUnknown;
}

/// What a mapper knows of the space around the UAV, in window order (see VoxelBox::index).
struct LocalMap {
  VoxelBox window;
  double resolution = 0;             ///< edge of a voxel [m]
  std::vector<float> occupancy;      ///< P(Occ) per voxel; exactly kUnknown where unknown
  std::vector<std::int32_t> labels;  ///< per voxel its cluster's position in `clusters`, or -1
  std::vector<Cluster> clusters;     ///< empty for mappers that find none

  std::int64_t dynamic_clusters() const {
    return std::count_if(clusters.begin(), clusters.end(),
                         [](const Cluster& c) { return c.dynamic; });
  }
};

}  // namespace ldm
