#pragma once
/// The record of a flight (experiments/RECORD.md; its scores: docs/avoidance.md).
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datasets/scenario/scenario.h"
#include "experiments/avoidance/flight_scores.h"
#include "experiments/avoidance/flight_settings.h"
#include "experiments/method/provenance.h"
#include "experiments/study/study.h"

namespace experiments {

struct FlightRecord {
  std::string command;  ///< repeats the flight
  std::string study, id;
  Point point;
  datasets::Scenario world;
  std::int64_t replicate = 0;
  std::uint64_t seed = 0;  ///< of the world and of the ranges' noise
  FlightSettings settings;
  std::vector<ReadFile> files;       ///< that it was made from
  bool serial = false;               ///< timed with nothing else running
  std::optional<std::string> error;  ///< it could not be flown; flight and scores are then empty
  Flight flight;
  FlightScores scores;
};
std::string to_json(const FlightRecord& record, const Provenance& provenance);

}  // namespace experiments
