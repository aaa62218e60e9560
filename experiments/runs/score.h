#pragma once
/// `ldm score`: a run against a reference, as a table on the terminal and as files in the run's
/// folder (no paper section; docs/scores.md).
#include <filesystem>
#include <ostream>

namespace experiments {

struct ScoreRequest {
  std::filesystem::path run;    ///< folder of `ldm run`
  std::filesystem::path truth;  ///< FILE.csv
  double gate = 0.5;            ///< how far from an object its cluster may be [m]
};

/// Prints the table to `out`, and writes score.csv and score.json into the run's folder.
/// @throws ldm::InvalidInput on a bad run or truth.
void score_run(const ScoreRequest& request, std::ostream& out);

}  // namespace experiments
