#pragma once
/// The record of a trial (experiments/RECORD.md).
#include <cstdint>
#include <optional>
#include <string>

#include "experiments/method/evaluation.h"
#include "experiments/method/plugins.h"
#include "experiments/method/provenance.h"
#include "experiments/study/sweep.h"
#include "ldm/parameters.h"

namespace experiments {

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

}  // namespace experiments
