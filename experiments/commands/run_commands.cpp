#include <iostream>

#include "experiments/commands/commands.h"
#include "experiments/commands/shared_options.h"
#include "experiments/runs/render.h"
#include "experiments/runs/run.h"
#include "experiments/runs/score.h"
#include "experiments/runs/simulate.h"
#include "experiments/runs/view.h"

namespace experiments {
namespace {

void add_simulate(CommandLine& line) {
  const auto request = std::make_shared<SimulateRequest>();
  Command command = line.add("simulate", "record a scenario as a log, with its truth beside it",
                             "ldm simulate scenario1 --seed 1 --frames 100 -o out.rawlog",
                             [&line, request] { simulate(*request, line.folders()); });
  command.option("SCENARIO", request->scenario, "name or .toml file").required();
  command.option("--seed", request->seed, "of the world").shows_default();
  command.option("--set", request->settings, "scenario.NAME=VALUE; may be repeated").repeatable();
  command.option("--frames", request->frames, "default: the scenario's").positive();
  command.option("-o,--output", request->output, "FILE.rawlog").required();
}

void add_run(CommandLine& line) {
  const auto request = std::make_shared<RunRequest>();
  Command command = line.add(
      "run", "run a method; writes clusters.csv, frames.csv, timing.csv and summary.json",
      "ldm run ldm scenario1 -o out --set particles.count=50000 --frames 300", [&line, request] {
        request->command = line.text();
        run(*request, line.folders());
      });
  add_method_and_input(command, *request);
  command.option("-o,--output", request->output, "folder, made if it is missing").required();
  command.option("--frames", request->frames, "stop after so many").positive();
  command
      .option("--rate", request->rate,
              "play at so many times the log's own speed, and tell which frames came late")
      .positive();
  command
      .option("--save-frames", request->save.frames,
              "frames whose occupied and free voxels go to OUTPUT/maps, as in 100,200")
      .separated_by_commas()
      .at_least_zero();
  command.option("--save-as", request->save.formats, "ply, bt (OctoMap), or ply,bt")
      .separated_by_commas()
      .shows_default();
  command.flag("--save-labels", request->save_labels,
               "write which points of each scan move to OUTPUT/labels, as SemanticKITTI's files; "
               "with a known truth also OUTPUT/true_labels");
}

void add_score(CommandLine& line) {
  const auto request = std::make_shared<ScoreRequest>();
  Command command = line.add(
      "score",
      "hold the clusters of a run, or its labels, against a reference; writes score.csv and "
      "score.json into RUN",
      "ldm score out --truth flight.truth.csv", [request] { score_run(*request, std::cout); });
  command.option("RUN", request->run, "output folder of `ldm run`").required();
  command.option("--truth", request->truth, "table of the true objects (docs/scores.md)");
  command.option("--labels", request->labels,
                 "folder of *.label files that say which points move, as SemanticKITTI's");
  command
      .option("--gate", request->gate,
              "how far from an object's box the centroid of its cluster may be [m]")
      .at_least_zero()
      .shows_default();
}

void add_render(CommandLine& line) {
  const auto request = std::make_shared<RenderRequest>();
  Command command = line.add("render", "draw what a method knows after a frame, or as a film",
                             "ldm render ldm scenario3 --frame 200 -o map.png",
                             [&line, request] { render(*request, line.folders()); });
  add_run_or_method(command, *request);
  command.option("-o,--output", request->output, "FILE.png, of one frame");
  command.option("--frame", request->frame, "its number, from 0").at_least_zero();
  command.option("--video", request->video, "FILE.mp4, at the log's rate; needs ffmpeg");
  command.option("--from", request->from, "first frame of the film")
      .at_least_zero()
      .shows_default();
  command.option("--to", request->to, "last frame of the film (default: the last of all)")
      .at_least_zero();
}

void add_view(CommandLine& line) {
  const auto request = std::make_shared<ViewRequest>();
  Command command =
      line.add("view", "show what a method knows, in a window while it runs",
               "ldm view ldm scenario3", [&line, request] { view(*request, line.folders()); });
  add_run_or_method(command, *request);
  command.option("--rate", request->rate, "times the log's own speed").positive().shows_default();
  command.flag("--paused", request->paused, "begin with a pause at the first frame");
}

}  // namespace

void add_runs(CommandLine& line) {
  add_simulate(line);
  add_run(line);
  add_score(line);
  add_render(line);
  add_view(line);
}

}  // namespace experiments
