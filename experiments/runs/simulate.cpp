#include "experiments/runs/simulate.h"

#include "datasets/rawlog/rawlog.h"
#include "datasets/scenario/simulation.h"
#include "experiments/runs/progress_line.h"

namespace experiments {

void simulate(const SimulateRequest& request, const DataFolders& folders) {
  const datasets::Scenario scenario =
      datasets::read_scenario(folders.scenarios.file(request.scenario));
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
