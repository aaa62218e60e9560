#pragma once
/// What a flight is worth: docs/avoidance.md defines each score.
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/avoidance/flight.h"

namespace experiments {

/// Name and value of every score; none where it has no meaning for this flight.
using FlightScores = std::vector<std::pair<std::string_view, std::optional<double>>>;
FlightScores flight_scores(const FlightTask& task, const Flight& flight);

}  // namespace experiments
