#pragma once
/// `ldm score`: a run against a reference, as a table on the terminal and as files in the run's
/// folder (no paper section; docs/scores.md).
#include <filesystem>
#include <optional>
#include <ostream>

namespace experiments {

struct ScoreRequest {
  std::filesystem::path run;                    ///< folder of `ldm run`
  std::optional<std::filesystem::path> truth;   ///< FILE.csv
  std::optional<std::filesystem::path> labels;  ///< folder of *.label files
  double gate = 0.5;                            ///< how far from an object its cluster may be [m]
};

/// Prints the table of objects and the line about points to `out`, whichever of the two references
/// there are, and writes score.json and, with objects, score.csv into the run's folder.
/// @throws ldm::InvalidInput on a bad run or reference, or without any.
void score_run(const ScoreRequest& request, std::ostream& out);

}  // namespace experiments
