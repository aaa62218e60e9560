#pragma once
/// Counts behind the scores of the occupancy grid: Eq. 18, case 1 and case 2 (paper Sec. 4.1.2).
#include <cstdint>

#include "experiments/metrics/truth_grid.h"
#include "ldm/types.h"

namespace experiments {

/// Sums over voxels and frames. A voxel is called occupied as by ldm::is_occupied: unknown counts
/// as free.
struct OccupancyTally {
  std::int64_t frames = 0;
  std::int64_t voxels = 0;
  std::int64_t true_positives = 0;  ///< solid, called occupied
  std::int64_t case1 = 0;           ///< solid, called free
  std::int64_t case2 = 0;           ///< not solid, called occupied
  std::int64_t case1_visible = 0;   ///< visible, called free
  std::int64_t case2_visible = 0;   ///< not visible, called occupied
  std::int64_t seen = 0;            ///< visible, called occupied
  std::int64_t invented = 0;        ///< neither solid nor visible, called occupied
  std::int64_t case2_grown = 0;     ///< neither solid nor beside a solid voxel, called occupied
  std::int64_t known = 0;           ///< voxels with P != 0.5
  double squared_error = 0;         ///< of P against solid, over the known voxels

  /// Voxels in their true state, solid or not; over `voxels` this is the accuracy.  Eq. (18)
  /// It cannot tell a good map from none: with 0.2 to 0.5 % of voxels solid and unknown counted as
  /// free, a map of nothing but unknown voxels (`empty_map`) comes out above most mappers.
  std::int64_t matched() const { return voxels - case1 - case2; }

  /// Add one frame. Requires `truth` filled for the map's window.
  void add(const ldm::LocalMap& map, const TruthGrid& truth);
};

}  // namespace experiments
