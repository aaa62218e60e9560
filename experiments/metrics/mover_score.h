#pragma once
/// Whether what moves is in the map, and called dynamic (no paper section; experiments/RECORD.md).
#include <cstdint>
#include <span>
#include <vector>

#include "datasets/frame.h"
#include "experiments/metrics/matching.h"
#include "experiments/metrics/mean.h"

namespace experiments {

/// An object moves while it is faster than VelocityTally::kStanding.
class MoverTally {
 public:
  /// Whether the voxels of the frame's returns on or beside moving objects are occupied.
  /// Requires a truth, and `grid` filled with it for the map's window.
  void add_returns(const datasets::Frame& frame, const ldm::LocalMap& map, const TruthGrid& grid);
  /// Which objects the clusters called dynamic stand for. Requires a truth, and `matching` of it.
  void add_clusters(const datasets::Truth& truth, const ldm::LocalMap& map,
                    const Matching& matching);

  /// 1 per voxel with such a return that is occupied, 0 per other one.
  const Mean& voxels_found() const { return voxels_found_; }
  /// 1 per frame of a visible moving object whose cluster is dynamic, 0 per other such frame.
  const Mean& called_dynamic() const { return called_dynamic_; }
  /// Per frame the dynamic clusters that are no moving object's: fragments of one, too.
  const Mean& false_movers() const { return false_movers_; }

 private:
  Mean voxels_found_, called_dynamic_, false_movers_;
  std::vector<std::size_t> voxels_;  // with a return of the frame at hand, window order
};

}  // namespace experiments
