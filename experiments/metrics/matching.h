#pragma once
/// Which cluster stands for which object (paper Sec. 4.1.3; the rule is ours).
#include <cstdint>
#include <optional>
#include <vector>

#include "experiments/metrics/truth_grid.h"
#include "ldm/types.h"

namespace experiments {

struct Matching {
  struct Object {
    bool in_map = false;   ///< it owns a voxel of the window
    bool visible = false;  ///< a visible voxel lies in it or beside it
    /// The cluster with most voxels in the object grown by one voxel; of equals the first.
    std::optional<std::size_t> cluster;
  };
  std::vector<Object> objects;               ///< in the order of the truth
  std::int64_t clusters_without_object = 0;  ///< clusters that overlap no grown object
};

/// Requires `truth` filled for the map's window.
Matching match(const ldm::LocalMap& map, const TruthGrid& truth);

}  // namespace experiments
