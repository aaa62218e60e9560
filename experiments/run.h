#pragma once
/// `ldm run`: one method over one scenario or log, with its clusters and times as tables
/// (no paper section).
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/data_folders.h"

namespace experiments {

struct RunRequest {
  std::string method;
  std::string input;                            ///< scenario (name or .toml) or .rawlog file
  std::filesystem::path output;                 ///< folder, made if it is missing
  std::optional<std::filesystem::path> config;  ///< parameter file
  std::vector<std::string> settings;            ///< name=value, stronger than the file
  std::optional<std::uint64_t> seed;            ///< of the scenario's world (default 1)
  std::optional<std::int64_t> frames;           ///< stop after so many
  std::string command;                          ///< for the summary
};

/// Writes clusters.csv, timing.csv and summary.json; until all three are complete, none is there.
/// Threads: all cores, unless set.
/// @throws ldm::InvalidInput on a bad request or log.
void run(const RunRequest& request, const DataFolders& folders);

}  // namespace experiments
