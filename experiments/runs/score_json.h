#pragma once
/// The score of a run, score.json (docs/scores.md).
#include <string>

#include "experiments/runs/truth_score.h"

namespace experiments {

/// @param truth, gate that the score was made with
std::string to_json(const TruthScore& score, const std::string& truth, double gate);

}  // namespace experiments
