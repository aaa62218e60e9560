#include "baselines/point_clusters.h"

namespace baselines {

void PointClusters::read(ldm::LocalMap& map) const {
  map.clusters.clear();
  map.labels.assign(map.window.count(), -1);
  for (const Group& group : groups_) {
    ldm::Cluster cluster = group.object;
    cluster.voxels = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    ldm::VoxelIndex low = map.window.origin + map.window.size, high = map.window.origin;
    for (const Eigen::Vector3d& p : group.points) {
      const ldm::VoxelIndex v = ldm::voxel_at(p, map.resolution);
      if (!map.window.contains(v)) continue;
      const std::size_t i = map.window.index(v);
      if (map.labels[i] >= 0 || !ldm::is_occupied(map.occupancy[i])) continue;
      map.labels[i] = static_cast<std::int32_t>(map.clusters.size());
      sum += (v.cast<double>().array() + 0.5).matrix();
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
      ++cluster.voxels;
    }
    if (cluster.voxels == 0) continue;
    cluster.position = (sum * map.resolution / cluster.voxels).cast<float>();
    cluster.size =
        ((high - low + ldm::VoxelIndex::Ones()).cast<double>() * map.resolution).cast<float>();
    map.clusters.push_back(cluster);
  }
}

}  // namespace baselines
