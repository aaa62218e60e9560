#include "experiments/metrics/matching.h"

#include <algorithm>

namespace experiments {

Matching match(const ldm::LocalMap& map, const TruthGrid& truth) {
  const std::size_t clusters = map.clusters.size();
  Matching matching;
  matching.objects.resize(truth.objects());
  std::vector<std::int32_t> overlap(truth.objects() * clusters);  // row: object, column: cluster

  for_each_voxel(map.window, [&](const ldm::VoxelIndex& v, std::size_t i) {
    if (truth.solid(v)) matching.objects[static_cast<std::size_t>(truth.object(v))].in_map = true;
    const bool visible = truth.visible(v);
    const std::int32_t cluster = map.labels.empty() ? -1 : map.labels[i];
    if (!visible && cluster < 0) return;
    const TruthGrid::Near near = truth.objects_near(v);
    for (std::size_t k = 0; k < near.count; ++k) {
      const auto object = static_cast<std::size_t>(near.objects[k]);
      if (visible) matching.objects[object].visible = true;
      if (cluster >= 0) ++overlap[object * clusters + static_cast<std::size_t>(cluster)];
    }
  });

  std::vector<bool> owned(clusters, false);
  for (std::size_t object = 0; object < truth.objects(); ++object) {
    std::int32_t largest = 0;
    for (std::size_t cluster = 0; cluster < clusters; ++cluster) {
      const std::int32_t voxels = overlap[object * clusters + cluster];
      if (voxels > 0) owned[cluster] = true;
      if (voxels > largest) {
        largest = voxels;
        matching.objects[object].cluster = cluster;
      }
    }
  }
  matching.clusters_without_object = std::count(owned.begin(), owned.end(), false);
  return matching;
}

}  // namespace experiments
