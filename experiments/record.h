#pragma once
/// Results as JSON: the record of a trial (experiments/RECORD.md) and the summary of a run.
#include <cstdint>
#include <optional>
#include <string>

#include "experiments/evaluation.h"
#include "experiments/plugins.h"
#include "experiments/provenance.h"
#include "experiments/sweep.h"
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

struct RunSummary {
  std::string command;
  std::string method, input;
  ldm::Parameters parameters;
  std::optional<PluginFile> plugin;
  Evaluation evaluation;
};
std::string to_json(const RunSummary& summary, const Provenance& provenance);

}  // namespace experiments
