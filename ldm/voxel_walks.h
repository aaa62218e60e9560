#pragma once
/// Several rays walked side by side: for paper Sec. 3.3.2.
#include <cstddef>
#include <cstdint>

#include "ldm/machine/lanes.h"
#include "ldm/voxel_walk.h"

namespace ldm {

/// Four walks, one in each lane of the processor's registers: the arithmetic of a step is done for
/// all of them at once. That halves the time of a scan's rays at 128^3.
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
    put(index_, walk.index_);
    for (int axis = 0; axis < 3; ++axis) {
      put(step_[axis], walk.step_[axis]);
      put(between_[axis], walk.between_[axis]);
      put(next_[axis], walk.next_[axis]);
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

}  // namespace ldm
