#pragma once
/// The summary of a run, summary.json (docs/run-output.md): what it was, and what repeats it.
#include <filesystem>
#include <optional>
#include <string>

#include "datasets/recording/scans/input_parameters.h"
#include "experiments/method/evaluation.h"
#include "experiments/method/method_on_input.h"
#include "experiments/method/plugins.h"
#include "experiments/method/provenance.h"
#include "experiments/runs/played_frames.h"
#include "ldm/parameters.h"

namespace experiments {

/// A run at the log's own speed.
struct RealTime {
  double rate = 1;  ///< times that speed
  Lateness late;
};

struct RunSummary {
  std::string command;
  MethodOnInput request;
  ldm::Parameters parameters;
  std::optional<datasets::InputParameters> input_parameters;  ///< of a recording
  Settings scenario_settings;                                 ///< `scenario.` values that were set
  datasets::InputCounts input_counts;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< see datasets::Frame [m]
  std::optional<PluginFile> plugin;
  std::optional<RealTime> real_time;
  bool interrupted = false;  ///< by Ctrl-C, after the last frame
  Evaluation evaluation;
};
std::string to_json(const RunSummary& summary, const Provenance& provenance);

/// The request that repeats a run, from its summary.json. Relative names of files are those of the
/// folder in which the run was started.
/// @throws ldm::InvalidInput if there is no such file, or not all that it takes in it.
MethodOnInput read_request(const std::filesystem::path& summary);

}  // namespace experiments
