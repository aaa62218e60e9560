#include "experiments/method_on_input.h"

#include "datasets/rawlog.h"
#include "datasets/simulation.h"

namespace experiments {

ldm::Parameters parameters_of(const MethodOnInput& request, const Method& method) {
  ldm::Parameters parameters = default_parameters(method);
  parameters.execution.threads = 0;
  if (request.config) {
    for (const Setting& setting : read_settings(*request.config)) {
      apply(setting, method, parameters);
    }
  }
  for (const std::string& argument : request.settings) {
    apply(parse_setting(argument), method, parameters);
  }
  return parameters;
}

std::unique_ptr<datasets::FrameSource> open_input(const MethodOnInput& request,
                                                  const DataFolders& folders,
                                                  std::optional<std::int64_t> frames) {
  if (!request.is_log()) {
    const datasets::Scenario scenario =
        datasets::read_scenario(folders.scenarios.file(request.input));
    return std::make_unique<datasets::Simulation>(scenario, request.seed.value_or(1), frames);
  }
  if (request.seed) {
    throw ldm::InvalidInput("--seed " + std::to_string(*request.seed) +
                            ": allowed: with a scenario; a log has no seed");
  }
  return std::make_unique<datasets::RawlogReader>(request.input);
}

}  // namespace experiments
