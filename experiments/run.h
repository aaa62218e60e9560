#pragma once
/// `ldm run`: one method over one scenario or log, with its clusters and times as tables
/// (no paper section).
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "experiments/method_on_input.h"

namespace experiments {

struct RunRequest : MethodOnInput {
  std::filesystem::path output;        ///< folder, made if it is missing
  std::optional<std::int64_t> frames;  ///< stop after so many
  std::string command;                 ///< for the summary
};

/// Writes clusters.csv, timing.csv and summary.json; until all three are complete, none is there.
/// @throws ldm::InvalidInput on a bad request or log.
void run(const RunRequest& request, const DataFolders& folders);

}  // namespace experiments
