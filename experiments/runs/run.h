#pragma once
/// `ldm run`: one method over one scenario or log, with its clusters and times as tables
/// (no paper section; docs/run-output.md).
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "experiments/method/method_on_input.h"
#include "experiments/runs/saved_maps.h"

namespace experiments {

struct RunRequest : MethodOnInput {
  std::filesystem::path output;        ///< folder, made if it is missing
  std::optional<std::int64_t> frames;  ///< stop after so many
  std::optional<double> rate;          ///< times the log's own speed; absent: as fast as it goes
  SavedMapsRequest save;
  bool save_labels = false;  ///< of the points of every scan
  std::string command;       ///< for the summary
};

/// Writes clusters.csv, frames.csv, timing.csv and summary.json, which appear together at the end,
/// and the maps of chosen frames, and labels/ with those of the points beside, of an input with a
/// truth, true_labels/. Ctrl-C ends the run after the frame at hand; what was finished is
/// then written, and the summary says so.
/// @throws ldm::InvalidInput on a bad request or log, std::runtime_error when it was interrupted.
void run(const RunRequest& request, const DataFolders& folders);

}  // namespace experiments
