#pragma once
/// What moving objects of a reference left behind in the saved maps of a run (no paper section;
/// docs/scores.md).
#include <filesystem>
#include <map>
#include <optional>

#include "experiments/runs/run_folder.h"
#include "experiments/runs/truth_table.h"

namespace experiments {

struct RunGhosts {
  std::int64_t frames = 0;                 ///< of the reference, with a saved map
  double voxels_per_frame = 0;             ///< see GhostTally
  std::optional<double> seconds_to_clear;  ///< the same [s]
};

/// By the rule of GhostTally, with the reference's boxes for solids. A frame without a saved map
/// does not count: its ghosts are those of the frames around it.
/// @param run the frames of the folder
/// @return none if no frame of the reference has a saved map
/// @throws ldm::InvalidInput if summary.json or a map is none that a run wrote.
std::optional<RunGhosts> ghosts_of_run(const std::filesystem::path& folder,
                                       const std::map<std::int64_t, RunFrame>& run,
                                       const TruthTable& truth);

}  // namespace experiments
