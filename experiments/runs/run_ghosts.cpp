#include "experiments/runs/run_ghosts.h"

#include <cmath>

#include "experiments/metrics/ghost_score.h"
#include "experiments/runs/ply_file.h"
#include "experiments/runs/saved_maps.h"
#include "experiments/runs/score_json.h"

namespace experiments {
namespace {

datasets::Truth boxes_of(const std::vector<TruthObject>& objects) {
  datasets::Truth truth;
  for (const TruthObject& object : objects) {
    datasets::ObjectState& state = truth.objects.emplace_back();
    state.dynamic = object.dynamic;
    state.position = object.position;
    state.size = object.size;
    datasets::Solid& box = state.solids.emplace_back();
    box.T_world_solid.translation = object.position;
    box.size = object.size;
  }
  return truth;
}

/// A map of which only the occupied voxels are known.
ldm::LocalMap map_of(const RunFrame& frame, const PlyFile& occupied, double resolution) {
  const auto voxels = [resolution](const Eigen::Vector3d& p) {
    return ldm::VoxelIndex((p / resolution).array().round().cast<int>());
  };
  ldm::LocalMap map;
  map.resolution = resolution;
  map.window = {voxels(frame.map.min()), voxels(frame.map.sizes())};
  map.occupancy.assign(map.window.count(), ldm::kUnknown);
  for (const PlyVertex& vertex : occupied.vertices) {
    const ldm::VoxelIndex v =
        ldm::voxel_at(vertex.position.cast<double>() + occupied.origin, resolution);
    if (!map.window.contains(v)) {
      throw ldm::InvalidInput("a voxel outside of the map that frames.csv tells of");
    }
    map.occupancy[map.window.index(v)] = vertex.occupancy;
  }
  return map;
}

}  // namespace

std::optional<RunGhosts> ghosts_of_run(const std::filesystem::path& folder,
                                       const std::map<std::int64_t, RunFrame>& run,
                                       const TruthTable& truth) {
  std::optional<double> resolution;
  GhostTally tally;
  TruthGrid grid;
  for (const auto& [number, frame] : run) {
    const std::filesystem::path file = occupied_ply(folder / "maps", number);
    const auto reference = truth.find(number);
    if (reference == truth.end() || !std::filesystem::exists(file)) continue;
    if (!resolution) resolution = summary_resolution(folder / "summary.json");
    try {
      const ldm::LocalMap map = map_of(frame, read_ply(file), *resolution);
      grid.fill(boxes_of(reference->second.objects), map.window, map.resolution);
      tally.add(frame.time, map, grid);
    } catch (const ldm::InvalidInput& error) {
      throw ldm::InvalidInput(file.string() + ": " + error.what());
    }
  }
  if (tally.frames() == 0) return {};
  tally.finish();
  return RunGhosts{tally.frames(),
                   static_cast<double>(tally.ghosts()) / static_cast<double>(tally.frames()),
                   tally.time_to_clear()};
}

}  // namespace experiments
