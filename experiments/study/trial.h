#pragma once
/// One trial of a study, from its id to its record (experiments/RECORD.md).
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/study/study.h"
#include "experiments/study/trial_record.h"

namespace experiments {

struct TrialRequest {
  std::string study;  ///< name, or its .toml file
  std::string id;
  StudyOptions options;
  bool serial = false;                    ///< the caller runs nothing beside it: the timing counts
  std::optional<std::string> failure;     ///< how it ended when it was run before; it is not run
  std::optional<std::string> data_dir;    ///< as given on the command line
  std::vector<std::string> plugins = {};  ///< loaded ones, as given on the command line
};

/// The command that runs the trial again: the same for the same trial, however it was asked for.
/// @param seeds so many that the trial is among them
std::string repeating_command(const TrialRequest& request, std::int64_t seeds, std::int64_t frames);

/// Runs trials of the study, and hands over each record when it is there. A failure inside of a
/// trial (simulation, method) is in its record's `error`. Successive ones in the same world share
/// it, frame by frame: it is drawn and scanned once. The records are the same as those of trials
/// that run alone. A request for serial timing shares nothing.
/// @param request without `id`
/// @throws ldm::InvalidInput on a bad study, id or parameter, before the first trial.
void run_trials(const TrialRequest& request, const std::vector<std::string>& ids,
                const std::function<void(const TrialRecord&)>& done);

/// Writes the record, under its final name only when it is complete, and before it the velocity
/// series, where there are any, to NAME.series.json beside NAME.json.
/// @throws ldm::InvalidInput if the folder cannot be written, std::runtime_error if the disk is
/// full.
void write_record(const TrialRecord& record, const std::filesystem::path& file);

}  // namespace experiments
