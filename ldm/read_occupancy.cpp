#include "ldm/read_occupancy.h"

#include "ldm/log_odds.h"

namespace ldm {

void read_occupancy(const RingBuffer<float>& log_odds, double resolution, LocalMap& map) {
  const RingIndex& index = log_odds.index();
  map.window = index.window();
  map.resolution = resolution;
  map.occupancy.resize(index.count());
  // Most neighbours are equal, at a clamp or unknown: the exponential is taken only at a change.
  float last_log_odds = 0;
  float last_probability = kUnknown;
  auto out = map.occupancy.begin();
  for (int z = 0; z < map.window.size.z(); ++z) {
    for (int y = 0; y < map.window.size.y(); ++y) {
      for (const RowPiece& piece : row_pieces(index, 0, map.window.size.x(), y, z)) {
        for (const float l :
             log_odds.cells().subspan(piece.slot, static_cast<std::size_t>(piece.length))) {
          if (l != last_log_odds) {
            last_log_odds = l;
            last_probability = static_cast<float>(probability(l));
          }
          *out++ = last_probability;
        }
      }
    }
  }
}

void count_points(const Scan& scan, LocalMap& map) {
  for (Cluster& cluster : map.clusters) cluster.points = 0;
  for (const Point& p : scan.points) {
    const VoxelIndex v = voxel_at(scan.T_world_sensor * p.cast<double>(), map.resolution);
    if (!map.window.contains(v)) continue;
    const std::int32_t label = map.labels[map.window.index(v)];
    if (label >= 0) ++map.clusters[static_cast<std::size_t>(label)].points;
  }
}

}  // namespace ldm
