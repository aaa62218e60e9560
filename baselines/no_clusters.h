#pragma once
/// What a map that finds no objects reads out of them.
#include "ldm/types.h"

namespace baselines {

/// No clusters, and no voxel in one. Requires map.window.
inline void read_no_clusters(ldm::LocalMap& map) {
  map.labels.assign(map.window.count(), -1);
  map.clusters.clear();
}

}  // namespace baselines
