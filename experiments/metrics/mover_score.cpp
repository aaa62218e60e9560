#include "experiments/metrics/mover_score.h"

#include <algorithm>

#include "experiments/metrics/velocity_score.h"

namespace experiments {
namespace {

bool moves(const datasets::ObjectState& object) {
  return object.velocity.norm() > VelocityTally::kStanding;
}

}  // namespace

void MoverTally::add_returns(const datasets::Frame& frame, const ldm::LocalMap& map,
                             const TruthGrid& grid) {
  voxels_.clear();
  for (const ldm::Point& p : frame.scan.points) {
    const ldm::VoxelIndex v =
        ldm::voxel_at(frame.scan.T_world_sensor * p.cast<double>(), map.resolution);
    if (map.window.contains(v)) voxels_.push_back(map.window.index(v));
  }
  std::sort(voxels_.begin(), voxels_.end());
  voxels_.erase(std::unique(voxels_.begin(), voxels_.end()), voxels_.end());
  for (const std::size_t i : voxels_) {
    const TruthGrid::Near near = grid.objects_near(map.window.voxel(i));
    const auto end = near.objects.begin() + static_cast<std::ptrdiff_t>(near.count);
    if (std::any_of(near.objects.begin(), end, [&](std::int32_t object) {
          return moves(frame.truth->objects[static_cast<std::size_t>(object)]);
        })) {
      voxels_found_.add(ldm::is_occupied(map.occupancy[i]) ? 1 : 0);
    }
  }
}

void MoverTally::add_clusters(const datasets::Truth& truth, const ldm::LocalMap& map,
                              const Matching& matching) {
  std::vector<bool> stands_for_mover(map.clusters.size());
  for (std::size_t i = 0; i < matching.objects.size(); ++i) {
    const Matching::Object& object = matching.objects[i];
    if (!object.in_map || !moves(truth.objects[i])) continue;
    if (object.cluster) stands_for_mover[*object.cluster] = true;
    if (!object.visible) continue;
    called_dynamic_.add(object.cluster && map.clusters[*object.cluster].dynamic ? 1 : 0);
  }
  double others = 0;
  for (std::size_t c = 0; c < map.clusters.size(); ++c) {
    others += map.clusters[c].dynamic && !stands_for_mover[c] ? 1 : 0;
  }
  false_movers_.add(others);
}

}  // namespace experiments
