#pragma once
/// Distance to the nearest occupied voxel: P. F. Felzenszwalb and D. P. Huttenlocher, Distance
/// Transforms of Sampled Functions, 2012 (closed loop after [11] of the paper).
#include <cstdint>
#include <vector>

#include "ldm/types.h"

namespace experiments {

struct Distance {
  double value = 0;                                    ///< [m]
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< of the value, world frame
};

/// Exact between voxel centres, trilinear between them, cut off at a reach beyond which nothing
/// counts. Space outside of the window is unknown, and taken as free.
class DistanceField {
 public:
  /// @param reach distances are at most this [m]
  explicit DistanceField(double reach) : reach_(reach) {}

  /// @param occupied per voxel of the window, in its order: 0 where free
  /// Cost: three passes over the window, about 15 ns a voxel.
  void build(const ldm::VoxelBox& window, double resolution,
             const std::vector<std::uint8_t>& occupied);

  /// From world point p [m]; the reach, and no gradient, where not all eight voxel centres around p
  /// lie in the window.
  Distance at(const Eigen::Vector3d& p) const;

  /// Per voxel of the window, in its order [m].
  const std::vector<float>& distances() const { return distances_; }

 private:
  double reach_;
  ldm::VoxelBox window_;
  double resolution_ = 0;
  std::vector<float> distances_;
};

}  // namespace experiments
