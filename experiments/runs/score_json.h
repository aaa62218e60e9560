#pragma once
/// The score of a run, score.json (docs/scores.md).
#include <filesystem>
#include <optional>
#include <string>

#include "experiments/runs/label_score.h"
#include "experiments/runs/run_ghosts.h"
#include "experiments/runs/score.h"
#include "experiments/runs/truth_score.h"

namespace experiments {

/// What a run was held against, each as far as there was a reference.
struct RunScores {
  std::optional<TruthScore> objects;
  std::optional<RunGhosts> ghosts;
  std::optional<LabelScore> points;
};

std::string to_json(const ScoreRequest& request, const RunScores& scores);

/// The resolution of a run's map, from its summary [m].
/// @throws ldm::InvalidInput if the file is none that a run wrote.
double summary_resolution(const std::filesystem::path& summary);

}  // namespace experiments
