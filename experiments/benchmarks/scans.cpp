#include "experiments/benchmarks/scans.h"

#include <string>

#include "datasets/scenario/simulation.h"
#include "experiments/method/data_folders.h"

namespace benchmarks {

datasets::Scenario flight_scenario(const Pattern& pattern) {
  const experiments::DataFolders folders({});
  datasets::Scenario scenario = datasets::read_scenario(folders.scenarios.file("scenario3_fast"));
  for (const auto& [group, count] : {std::pair{"boxes", 4},
                                     {"cylinders", 4},
                                     {"standing_persons", 3},
                                     {"moving_boxes", 3},
                                     {"moving_cylinders", 3},
                                     {"walking_persons", 3}}) {
    datasets::set_scenario_value(scenario, "groups." + std::string(group) + ".count",
                                 std::to_string(count));
  }
  scenario.sensor.channels = pattern.channels;
  scenario.sensor.azimuths = pattern.azimuths;
  return scenario;
}

const std::vector<ldm::Scan>& Scans::of(const Pattern& pattern) {
  std::vector<ldm::Scan>& scans = by_pattern_[pattern];
  if (!scans.empty()) return scans;
  datasets::Simulation simulation(flight_scenario(pattern), kFlightSeed, frames_);
  datasets::Frame frame;
  while (simulation.next(frame)) scans.push_back(frame.scan);
  return scans;
}

}  // namespace benchmarks
