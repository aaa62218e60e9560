#pragma once
/// Rays of a scan in a box of voxels: where they end, and which voxels they cross (Amanatides and
/// Woo, 1987): for paper Sec. 3.3.2.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "ldm/machine/lanes.h"
#include "ldm/types.h"

namespace ldm {

/// Ends of up to kMost rays at a time. Plain arrays and a loop without branches: the compiler turns
/// it into vectors.
class RayEnds {
 public:
  static constexpr std::size_t kMost = 64;

  /// @param sensor origin of the rays, inside the box (0, size) of voxels
  /// @param R_box_sensor from the frame of the rays to the box's axes, times voxels per metre
  RayEnds(const Eigen::Vector3f& sensor, const Eigen::Matrix3f& R_box_sensor,
          const Eigen::Vector3i& size)
      : sensor_(sensor), R_box_sensor_(R_box_sensor), size_(size) {}

  /// Ray i goes from the sensor to rays[i], or on for ever. At most kMost.
  void find(std::span<const Point> rays, bool for_ever);

  /// What the last voxel of ray i is: flag::kOccupied if it ends in the box, flag::kFree if it
  /// leaves the box there, flag::kNone for a ray without a direction.
  std::uint8_t flag(std::size_t i) const { return static_cast<std::uint8_t>(flag_[i]); }
  /// That voxel: its row-major position in the box, x fastest.
  std::size_t index(std::size_t i) const { return static_cast<std::size_t>(index_[i]); }

 private:
  Eigen::Vector3f sensor_;
  Eigen::Matrix3f R_box_sensor_;
  Eigen::Vector3i size_;
  std::array<std::int32_t, kMost> flag_, index_;
};

/// Visits the voxels along origin + t * direction in a box of voxels, by their linear index.
///
/// The parameters at which the ray meets the next wall of each axis are integers, 2^30 where it
/// leaves the box. Which of three comes next looks like chance: with integers a step is arithmetic
/// alone, without the branches, guessed wrongly, of floating point.
class VoxelWalk {
 public:
  /// Where a walk is and how it goes on, axis by axis.
  struct State {
    int index = 0;
    std::int32_t step[3] = {};     // of the index
    std::int32_t between[3] = {};  // walls
    std::int32_t next[3] = {};     // wall
  };

  /// Stands still in the voxel of that linear index.
  explicit VoxelWalk(std::size_t index) : state_{static_cast<int>(index), {}, {}, {}} {}
  /// @param origin of the ray, in voxels from the box's lowest corner
  /// @param direction per unit of t, in voxels; not zero
  /// @param exit t > 0 at which the ray leaves the box for good
  /// @param voxel in which the walk begins, counted from the lowest of the box
  /// @param size voxels of the box
  VoxelWalk(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float exit,
            const VoxelIndex& voxel, const Eigen::Vector3i& size)
      : unit_(exit / kExit) {
    state_.index = voxel.x() + size.x() * (voxel.y() + size.y() * voxel.z());
    const int stride[3] = {1, size.x(), size.x() * size.y()};
    for (int axis = 0; axis < 3; ++axis) {
      const bool up = direction[axis] > 0;
      const float inverse = kExit / (direction[axis] * exit);
      const float to_wall = static_cast<float>(voxel[axis] + (up ? 1 : 0)) - origin[axis];
      const bool moves = direction[axis] != 0;
      state_.step[axis] = up ? stride[axis] : -stride[axis];
      // What lies beyond the exit is never met: bounds keep the sums in an integer.
      state_.between[axis] = moves ? bounded(std::abs(inverse), kLongest) : 0;
      state_.next[axis] = moves ? bounded(to_wall * inverse, kNever) : kNever;
    }
  }

  const State& state() const { return state_; }
  std::size_t index() const { return static_cast<std::size_t>(state_.index); }

  /// t at which the present voxel is left.
  float leaves_at() const {
    const auto& next = state_.next;
    return static_cast<float>(std::min({next[0], next[1], next[2]})) * unit_;
  }

  /// The walk after so many steps along each axis, if it takes them.
  VoxelWalk after(const Eigen::Vector3i& steps) const {
    VoxelWalk later = *this;
    for (int axis = 0; axis < 3; ++axis) {
      later.state_.index += state_.step[axis] * steps[axis];
      later.state_.next[axis] += state_.between[axis] * steps[axis];
    }
    return later;
  }

  /// One step along the axis with a 1.
  struct Step {
    int x, y, z;
  };
  /// Into the next voxel, which may lie outside the box: see BorderAhead.
  Step step() {
    auto& [index, step, between, next] = state_;
    const int x = (next[0] <= next[1]) & (next[0] <= next[2]);
    const int y = ~x & (next[1] <= next[2]);
    const int z = 1 - x - y;
    index += (step[0] & -x) + (step[1] & -y) + (step[2] & -z);
    next[0] += between[0] & -x;
    next[1] += between[1] & -y;
    next[2] += between[2] & -z;
    return {x, y, z};
  }

 private:
  static constexpr float kExit = 1 << 30;
  static constexpr float kLongest = (1 << 30) - (1 << 20);
  static constexpr std::int32_t kNever = 0x7fffff80;  // the largest float below 2^31

  static std::int32_t bounded(float t, float most) {
    return static_cast<std::int32_t>(std::clamp(t, 0.0F, most));
  }

  float unit_ = 0;
  State state_;
};

/// Four walks, one in each lane of the processor's registers: the arithmetic of a step is done for
/// all of them at once.
class VoxelWalks {
 public:
  static constexpr int kLanes = 4;

  /// Let `walk` go on in `lane`.
  void set(int lane, const VoxelWalk& walk) {
    constexpr Int32x4 kNumbers = {0, 1, 2, 3};
    const Int32x4 here = kNumbers == lane;
    const auto put = [&](Int32x4& lanes, std::int32_t value) {
      lanes = here ? Int32x4{} + value : lanes;
    };
    const VoxelWalk::State& state = walk.state();
    put(index_, state.index);
    for (int axis = 0; axis < 3; ++axis) {
      put(step_[axis], state.step[axis]);
      put(between_[axis], state.between[axis]);
      put(next_[axis], state.next[axis]);
    }
  }

  /// Linear index of the voxel in which the walk of `lane` is.
  std::size_t index(int lane) const { return static_cast<std::size_t>(index_[lane]); }

  /// As VoxelWalk::step, in each lane.
  void step() {
    const Int32x4 not_x = (next_[0] > next_[1]) | (next_[0] > next_[2]);
    const Int32x4 z_first = next_[1] > next_[2];
    const Int32x4 y = not_x & ~z_first;
    const Int32x4 z = not_x & z_first;
    index_ += (step_[0] & ~not_x) | (step_[1] & y) | (step_[2] & z);
    next_[0] += between_[0] & ~not_x;
    next_[1] += between_[1] & y;
    next_[2] += between_[2] & z;
  }

 private:
  Int32x4 index_ = {};
  Int32x4 step_[3] = {};
  Int32x4 between_[3] = {};
  Int32x4 next_[3] = {};
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
