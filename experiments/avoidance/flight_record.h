#pragma once
/// The record of a flight (experiments/RECORD.md; its scores: docs/avoidance.md).
#include <string>

#include "datasets/scenario/scenario.h"
#include "experiments/avoidance/flight_scores.h"
#include "experiments/avoidance/flight_settings.h"
#include "experiments/method/provenance.h"
#include "experiments/study/trial_record.h"

namespace experiments {

/// `scenario_seed` is that of the world and of the ranges' noise; what follows from world and
/// settings (scenario, method, frames, filter_seed, scenario_file_hash, plugin) may be empty.
struct FlightRecord : RecordHead {
  datasets::Scenario world;
  FlightSettings settings;
  Flight flight;        ///< empty if it could not be flown
  FlightScores scores;  ///< likewise
};
std::string to_json(const FlightRecord& record, const Provenance& provenance);

}  // namespace experiments
