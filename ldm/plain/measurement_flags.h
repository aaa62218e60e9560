#pragma once
/// The measurement flag grid of paper Sec. 3.3.2 written plainly, in double precision.
#include <vector>

#include "ldm/types.h"

namespace ldm::plain {

/// What one scan says of a voxel.
struct VoxelFlag {
  enum class Kind { kNone, kShadow, kFree, kOccupied };
  Kind kind = Kind::kNone;
  double behind = 0;  ///< shadow only: from the centre of the nearest obstacle's voxel [m]
};

/// Flags of all voxels of `window`, in window order.
///
/// One ray is cast for each voxel with a return, from the sensor through its centre to the end of
/// the map: free before the voxel, shadow behind it. Each voxel in which a ray leaves the map (a
/// return beyond it or, if `use_no_returns`, a ray without a return) gets a free ray of its own.
/// A hit beats a crossing, a crossing beats a shadow.
std::vector<VoxelFlag> flag_voxels(const Scan& scan, const VoxelBox& window, double resolution,
                                   bool use_no_returns);

}  // namespace ldm::plain
