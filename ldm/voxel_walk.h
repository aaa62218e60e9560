#pragma once
/// Which voxels a ray crosses, one after the other (Amanatides and Woo, 1987): for paper
/// Sec. 3.3.2.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "ldm/types.h"

namespace ldm {

/// Visits the voxels along origin + t * direction in a box of voxels, by their linear index.
///
/// The parameters at which the ray meets the next wall of each axis are integers, 2^30 where it
/// leaves the box. Which of three comes next looks like chance: with integers a step is arithmetic
/// alone, and takes a third of the time of the branches, guessed wrongly, of floating point.
class VoxelWalk {
 public:
  /// Stands still in the voxel of that linear index.
  explicit VoxelWalk(std::size_t index) : index_(static_cast<int>(index)) {}
  /// @param origin of the ray, in voxels from the box's lowest corner
  /// @param direction per unit of t, in voxels; not zero
  /// @param exit t > 0 at which the ray leaves the box for good
  /// @param voxel in which the walk begins, counted from the lowest of the box
  /// @param size voxels of the box
  VoxelWalk(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float exit,
            const VoxelIndex& voxel, const Eigen::Vector3i& size)
      : unit_(exit / kExit), index_(voxel.x() + size.x() * (voxel.y() + size.y() * voxel.z())) {
    const int stride[3] = {1, size.x(), size.x() * size.y()};
    for (int axis = 0; axis < 3; ++axis) {
      const bool up = direction[axis] > 0;
      const float inverse = kExit / (direction[axis] * exit);
      const float to_wall = static_cast<float>(voxel[axis] + (up ? 1 : 0)) - origin[axis];
      const bool moves = direction[axis] != 0;
      step_[axis] = up ? stride[axis] : -stride[axis];
      // What lies beyond the exit is never met: bounds keep the sums in an integer.
      between_[axis] = moves ? bounded(std::abs(inverse), kLongest) : 0;
      next_[axis] = moves ? bounded(to_wall * inverse, kNever) : kNever;
    }
  }

  std::size_t index() const { return static_cast<std::size_t>(index_); }

  /// t at which the present voxel is left.
  float leaves_at() const {
    return static_cast<float>(std::min({next_[0], next_[1], next_[2]})) * unit_;
  }

  /// The walk after so many steps along each axis, if it takes them.
  VoxelWalk after(const Eigen::Vector3i& steps) const {
    VoxelWalk later = *this;
    for (int axis = 0; axis < 3; ++axis) {
      later.index_ += step_[axis] * steps[axis];
      later.next_[axis] += between_[axis] * steps[axis];
    }
    return later;
  }

  /// One step along the axis with a 1.
  struct Step {
    int x, y, z;
  };
  /// Into the next voxel, which may lie outside the box: see BorderAhead.
  Step step() {
    const int x = (next_[0] <= next_[1]) & (next_[0] <= next_[2]);
    const int y = ~x & (next_[1] <= next_[2]);
    const int z = 1 - x - y;
    index_ += (step_[0] & -x) + (step_[1] & -y) + (step_[2] & -z);
    next_[0] += between_[0] & -x;
    next_[1] += between_[1] & -y;
    next_[2] += between_[2] & -z;
    return {x, y, z};
  }

 private:
  friend class VoxelWalks;
  static constexpr float kExit = 1 << 30;
  static constexpr float kLongest = (1 << 30) - (1 << 20);
  static constexpr std::int32_t kNever = 0x7fffff80;  // the largest float below 2^31

  static std::int32_t bounded(float t, float most) {
    return static_cast<std::int32_t>(std::clamp(t, 0.0F, most));
  }

  float unit_ = 0;
  int index_ = 0;
  std::int32_t step_[3] = {};
  std::int32_t between_[3] = {};
  std::int32_t next_[3] = {};
};

/// How far the border of the box is ahead of a walk.
class BorderAhead {
 public:
  /// @param voxel in which the walk is
  BorderAhead(const Eigen::Vector3f& direction, const VoxelIndex& voxel,
              const Eigen::Vector3i& size) {
    for (int axis = 0; axis < 3; ++axis) {
      left_[axis] = direction[axis] > 0 ? size[axis] - 1 - voxel[axis] : voxel[axis];
    }
  }

  /// False if the step led out of the box.
  bool inside_after(const VoxelWalk::Step& step) {
    left_[0] -= step.x;
    left_[1] -= step.y;
    left_[2] -= step.z;
    return (left_[0] | left_[1] | left_[2]) >= 0;
  }

 private:
  std::int32_t left_[3];  // voxels to the border
};

}  // namespace ldm
