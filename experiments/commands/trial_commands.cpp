#include <iostream>

#include "experiments/avoidance/flight_study.h"
#include "experiments/avoidance/fly.h"
#include "experiments/commands/commands.h"
#include "experiments/commands/shared_options.h"
#include "experiments/study/trial.h"

namespace experiments {
namespace {

struct TrialsRequest {
  TrialRequest trial;  // without id
  std::vector<std::string> ids;
  std::filesystem::path output;

  std::filesystem::path record_of(const std::string& id) const {
    return ids.size() == 1 ? output : output / (id + ".json");
  }
};

void run_and_write(TrialsRequest request, CommandLine& line) {
  TrialRequest& trial = request.trial;
  trial.data_dir = line.data_dir();
  trial.plugins = line.plugins();
  const auto note = [&](const std::string& id, const std::optional<std::string>& error) {
    if (error && !trial.failure) line.complain("trial " + id + " failed: " + *error);
  };
  if (is_flight_study(line.folders().studies.file(trial.study))) {
    for (const std::string& id : request.ids) {
      trial.id = id;
      note(id, run_flight_trial(trial, request.record_of(id)));
    }
    return;
  }
  run_trials(trial, request.ids, [&](const TrialRecord& record) {
    write_record(record, request.record_of(record.id));
    note(record.id, record.error);
  });
}

void add_fly(CommandLine& line) {
  const auto request = std::make_shared<FlyRequest>();
  Command command = line.add(
      "fly",
      "fly from start to goal by what a method maps; writes flight.csv, obstacles.csv, plans.csv "
      "and summary.json",
      "ldm fly ldm moving10_10 --seed 1 -o out", [&line, request] {
        request->command = line.text();
        fly(*request, line.folders(), std::cout);
      });
  command.option("ARM", request->arm, "a method, or blind, oracle, oracle_future").required();
  command.option("WORLD", request->world, "name in datasets/corridors, or .toml file").required();
  command.option("--seed", request->seed, "of the world").shows_default();
  command
      .option(
          "--set", request->settings,
          "name=value of flight, trust or map (docs/avoidance.md), or scenario.NAME=VALUE of the "
          "world; may be repeated")
      .repeatable();
  command.option("-o,--output", request->output, "folder, made if it is missing").required();
  command.option("--video", request->video,
                 "FILE.mp4: map, clusters, UAV, planned and flown path; needs ffmpeg");
}

void add_trial(CommandLine& line) {
  const auto request = std::make_shared<TrialsRequest>();
  Command command = line.add("trial", "run one trial of a study and write its record, or several",
                             "ldm trial table1 scenario1.ldm.s001 -o record.json",
                             [&line, request] { run_and_write(*request, line); });
  add_study_options(command, request->trial.study, request->trial.options);
  command
      .option("ID", request->ids,
              "an id that `ldm trials STUDY` lists; of several, successive ones in the same world "
              "share it")
      .required();
  command
      .option("-o,--output", request->output,
              "FILE.json; of several trials the folder of their ID.json")
      .required();
  command.flag("--serial", request->trial.serial,
               "nothing else runs beside it: mark the times as such and keep all samples");
  command.option("--failed", request->trial.failure,
                 "do not run it: write the record of a trial that ended so");
}

}  // namespace

void add_trials(CommandLine& line) {
  add_fly(line);
  add_trial(line);
}

}  // namespace experiments
