#include "experiments/runs/simulate.h"

#include "datasets/rawlog/rawlog.h"
#include "datasets/scenario/simulation.h"
#include "experiments/method/settings.h"
#include "experiments/runs/progress_line.h"

namespace experiments {

void simulate(const SimulateRequest& request, const DataFolders& folders) {
  datasets::Scenario scenario = datasets::read_scenario(folders.scenarios.file(request.scenario));
  for (const std::string& argument : request.settings) {
    const Setting setting = parse_setting(argument);
    if (scenario_key(setting).empty())
      refuse(setting, "scenario.NAME=VALUE, as `ldm parameters scenario` lists them");
    apply(setting, scenario);
  }
  datasets::Simulation simulation(scenario, request.seed, request.frames);
  datasets::RawlogWriter log(request.output, simulation.lidar(), simulation.T_uav_sensor());
  ProgressLine progress(simulation.size());
  datasets::Frame frame;
  while (simulation.next(frame)) {
    log.write(frame.scan.time, simulation.uav_pose(), simulation.range_image(),
              frame.truth.value());
    progress.show(frame.index + 1,
                  std::to_string(simulation.world().obstacles.size()) + " obstacles");
  }
  log.close();
}

}  // namespace experiments
