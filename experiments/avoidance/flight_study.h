#pragma once
/// The study of the closed loop as data: a TOML file, and the trials it stands for.
///
///     title = "Who reaches the goal"
///     worlds = ["still8", "moving10_10"]     # of datasets/corridors
///     methods = ["ldm", "circular_buffer"]
///     controls = ["blind", "oracle"]         # their presence makes it such a study
///     seeds = 20                             # replicates `first_seed`, `first_seed` + 1, ...
///     first_seed = 1                         # default 1: other seeds for tuning
///     frames = 400                           # scans after which a flight is given up
///     [set], [sweep]                         # as in every study, of trust., flight., the map, and
///                                            # `scenario.` values of the worlds
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/scenario/scenario.h"
#include "experiments/avoidance/flight.h"
#include "experiments/avoidance/flight_settings.h"
#include "experiments/method/data_folders.h"
#include "experiments/study/study_json.h"
#include "experiments/study/trial.h"

namespace experiments {

/// Its scenarios are the worlds.
struct FlightStudy : StudyBase {
  std::vector<std::string> arms;  ///< controls, then methods
  std::int64_t first_seed = 1;
};

/// Whether a study's file describes flights.
/// @throws ldm::InvalidInput if it cannot be read
bool is_flight_study(const std::filesystem::path& file);

/// Reads and checks all of it: every value of every point fits every arm that uses it.
/// @throws ldm::InvalidInput with file, line, key, value and what is allowed
FlightStudy read_flight_study(const std::filesystem::path& file, const DataFolder& corridors,
                              const StudyOptions& options = {});

struct FlightTrial {
  std::string id;  ///< `still8.ldm.s001`; with a sweep `still8.ldm.p02.s001`
  std::size_t world = 0, arm = 0, point = 0;
  std::int64_t replicate = 1;
};

/// All, replicate by replicate.
std::vector<FlightTrial> flight_trials(const FlightStudy& study);

StudyOutline outline(const FlightStudy& study);

/// The world of a replicate is the same for every arm and point.
FlightTask flight_task(const datasets::Scenario& world, std::uint64_t seed,
                       const FlightSettings& settings);

/// Fly one trial, unless the request says how it failed, and write its record
/// (experiments/RECORD.md).
/// @return why the flight failed, as the record says; nothing if it was flown, whatever it hit
/// @throws ldm::InvalidInput on a bad study, id or parameter, or if the file cannot be written
std::optional<std::string> run_flight_trial(const TrialRequest& request,
                                            const std::filesystem::path& file);

}  // namespace experiments
