#pragma once
/// The record of a trial (experiments/RECORD.md).
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/method/evaluation.h"
#include "experiments/method/plugins.h"
#include "experiments/method/provenance.h"
#include "experiments/method/result_json.h"
#include "experiments/study/study.h"
#include "ldm/parameters.h"

namespace experiments {

/// What the record of a trial of every kind begins with.
struct RecordHead {
  std::string command;  ///< repeats the trial
  std::string study, id, scenario, method;
  std::int64_t replicate = 0;
  Point point;
  std::uint64_t scenario_seed = 0, filter_seed = 0;
  std::int64_t frames = 0;
  std::vector<ReadFile> files;  ///< that it was made from
  std::string scenario_file_hash;
  std::optional<PluginFile> plugin;  ///< that the method came from
  bool serial = false;               ///< timed with nothing else running
  std::optional<std::string> error;  ///< the trial failed; there is then nothing else
};

struct TrialRecord : RecordHead {
  ldm::Parameters parameters;
  Evaluation evaluation;  ///< empty if the trial failed
};

/// @param point as it is to be written
Json head_json(const RecordHead& head, Json point, Json parameters, const Provenance& provenance);

/// @param series_bytes length of `series_json`, so that a file cut short is noticed
std::string to_json(const TrialRecord& record, const Provenance& provenance,
                    std::size_t series_bytes);

/// The velocity series; empty if there are none.
std::string series_json(const TrialRecord& record);

}  // namespace experiments
