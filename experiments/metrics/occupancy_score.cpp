#include "experiments/metrics/occupancy_score.h"

namespace experiments {

void OccupancyTally::add(const ldm::LocalMap& map, const TruthGrid& truth) {
  ++frames;
  for_each_voxel(map.window, [&](const ldm::VoxelIndex& v, std::size_t i) {
    const float p = map.occupancy[i];
    const bool occupied = ldm::is_occupied(p);
    const bool solid = truth.solid(v);
    const bool visible = truth.visible(v);
    ++voxels;
    true_positives += solid && occupied;
    case1 += solid && !occupied;
    case2 += !solid && occupied;
    case1_visible += visible && !occupied;
    case2_visible += !visible && occupied;
    seen += visible && occupied;
    invented += !visible && !solid && occupied;
    case2_grown += occupied && !solid && truth.objects_near(v).count == 0;
    if (p != ldm::kUnknown) {
      ++known;
      const double error = static_cast<double>(p) - (solid ? 1.0 : 0.0);
      squared_error += error * error;
    }
  });
}

}  // namespace experiments
