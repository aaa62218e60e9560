#pragma once
/// Results as JSON: the record of a trial (experiments/RECORD.md), the summary of a run and its
/// score.
#include <cstdint>
#include <optional>
#include <string>

#include "datasets/input_parameters.h"
#include "experiments/evaluation.h"
#include "experiments/method_on_input.h"
#include "experiments/played_frames.h"
#include "experiments/plugins.h"
#include "experiments/provenance.h"
#include "experiments/sweep.h"
#include "experiments/truth_score.h"
#include "ldm/parameters.h"

namespace experiments {

/// Updates left out of the timing while caches and memory settle; half of a shorter run.
inline constexpr std::int64_t kWarmUpFrames = 10;

struct TrialRecord {
  std::string command;  ///< repeats the trial
  std::string study, id, scenario, method;
  std::int64_t replicate = 0;
  Point point;
  std::uint64_t scenario_seed = 0, filter_seed = 0;
  std::int64_t frames = 0;
  ldm::Parameters parameters;
  std::string scenario_file_hash;
  std::optional<PluginFile> plugin;  ///< that the method came from
  bool serial = false;               ///< timed with nothing else running
  std::optional<std::string> error;  ///< the trial failed; `evaluation` is then empty
  Evaluation evaluation;
};
std::string to_json(const TrialRecord& record, const Provenance& provenance);

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
  datasets::InputCounts input_counts;
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

/// @param truth, gate that the score was made with
std::string to_json(const TruthScore& score, const std::string& truth, double gate);

}  // namespace experiments
