#pragma once
/// The score of a run, score.json (docs/scores.md).
#include <filesystem>
#include <optional>
#include <string>

#include "experiments/runs/run_ghosts.h"
#include "experiments/runs/truth_score.h"

namespace experiments {

/// @param truth, gate that the score was made with
std::string to_json(const TruthScore& score, const std::optional<RunGhosts>& ghosts,
                    const std::string& truth, double gate);

/// The resolution of a run's map, from its summary [m].
/// @throws ldm::InvalidInput if the file is none that a run wrote.
double summary_resolution(const std::filesystem::path& summary);

}  // namespace experiments
