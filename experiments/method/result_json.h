#pragma once
/// What the record of a trial, the summary of a run and its score have in common, as JSON
/// (experiments/RECORD.md).
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "datasets/recording/scans/input_parameters.h"
#include "experiments/method/evaluation.h"
#include "experiments/method/plugins.h"
#include "experiments/method/provenance.h"

namespace experiments {

using Json = nlohmann::ordered_json;

/// Updates left out of the timing while caches and memory settle; half of a shorter run.
inline constexpr std::int64_t kWarmUpFrames = 10;

/// Every parameter by its name.
Json parameters_json(const ldm::Parameters& parameters);
Json parameters_json(const datasets::InputParameters& parameters);

/// The program, the machine, and the plugin that the method came from.
Json provenance_json(const Provenance& provenance, const std::optional<PluginFile>& plugin);

/// Every score by its name; null where there was nothing to judge.
Json scores_json(const Tallies& tallies);

/// Times without warm-up [ms].
/// @param serial nothing else ran: the raw samples are worth keeping
Json timing_json(const StageClock& clock, bool serial);

/// One line for each key of the outermost object: readable, and short for the long arrays.
std::string dump(const Json& json);

}  // namespace experiments
