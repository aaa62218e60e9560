#pragma once
/// Ground truth of one frame on the grid of the local map (paper Sec. 4.1.2).
#include <array>
#include <cstdint>
#include <vector>

#include "datasets/frame.h"
#include "ldm/types.h"

namespace experiments {

/// Which voxels of a window are solid, which are visible, and which objects are near.
class TruthGrid {
 public:
  /// Memory is reused from frame to frame.
  void fill(const datasets::Truth& truth, const ldm::VoxelBox& window, double resolution);

  const ldm::VoxelBox& window() const { return window_; }
  /// Number of objects in the truth.
  std::size_t objects() const { return objects_; }

  /// Position in `truth.objects` of the object that holds the voxel's centre, or -1. Requires v in
  /// the window or beside it.
  std::int32_t object(const ldm::VoxelIndex& v) const { return owner_[padded_.index(v)]; }
  bool solid(const ldm::VoxelIndex& v) const { return object(v) >= 0; }
  /// True if a noise-free ray hits the voxel. Requires v in the window.
  bool visible(const ldm::VoxelIndex& v) const { return visible_[window_.index(v)] != 0; }

  /// Voxels of the window that objects hold which move at some time.
  const std::vector<ldm::VoxelIndex>& moving() const { return moving_; }

  /// The objects that own v or one of its 26 neighbours; the first `count` are valid.
  struct Near {
    std::array<std::int32_t, 27> objects;
    std::size_t count = 0;
  };
  /// Requires v in the window.
  Near objects_near(const ldm::VoxelIndex& v) const;

 private:
  void find_moving(const datasets::Truth& truth, double resolution);

  ldm::VoxelBox window_;
  ldm::VoxelBox padded_;  ///< one voxel wider all round: objects beside the window count as near
  std::size_t objects_ = 0;
  std::vector<std::int32_t> owner_;
  std::vector<std::uint8_t> visible_;
  std::vector<ldm::VoxelIndex> moving_;
};

}  // namespace experiments
