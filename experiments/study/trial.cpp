#include "experiments/study/trial.h"

#include <exception>

#include "datasets/files/partial_file.h"
#include "datasets/files/text.h"
#include "datasets/scenario/simulation.h"
#include "experiments/study/seeds.h"

namespace experiments {
namespace {

/// The same for the same trial, however it was asked for.
std::string repeating_command(const TrialRequest& request, const TrialRecord& record) {
  std::vector<std::string> words = {"ldm"};
  if (request.data_dir) words.insert(words.end(), {"--data-dir", *request.data_dir});
  for (const std::string& file : request.plugins) words.insert(words.end(), {"--plugin", file});
  words.insert(words.end(),
               {"trial", request.study, request.id, "--seeds", std::to_string(record.replicate),
                "--frames", std::to_string(record.frames), "-o", request.id + ".json"});
  for (const std::string& method : request.options.methods) {
    words.insert(words.end(), {"--method", method});
  }
  return datasets::command_line(words);
}

}  // namespace

TrialRecord run_trial(const TrialRequest& request) {
  const DataFolders folders(request.data_dir);
  const Study study =
      read_study(folders.studies.file(request.study), folders.scenarios, request.options);
  const Trial trial = find_trial(study, request.id);
  const Entrant& entrant = study.entrants[trial.entrant];
  const datasets::Scenario scenario = trial_scenario(study, trial);

  TrialRecord record;
  record.study = study.name;
  record.id = request.id;
  record.scenario = scenario.name;
  record.method = entrant.name;
  record.replicate = trial.replicate;
  record.point = study.points[trial.point];
  record.frames = study.frames;
  record.parameters = trial_parameters(study, trial);
  record.scenario_seed = scenario_seed(scenario.name, trial.replicate);
  record.filter_seed = record.parameters.execution.seed;
  record.scenario_file_hash = datasets::scenario_hash(scenario);
  record.plugin = plugin_of(*entrant.method);
  record.serial = request.serial;
  record.command = repeating_command(request, record);
  try {
    datasets::Simulation simulation(scenario, record.scenario_seed, record.frames);
    record.evaluation = evaluate(*entrant.method, record.parameters, simulation,
                                 {.frames = {}, .series = study.series, .observer = {}});
  } catch (const std::exception& error) {
    record.error = datasets::single_line(error.what());
  }
  return record;
}

void write_record(const TrialRecord& record, const std::filesystem::path& path) {
  datasets::PartialFile file(path);
  file.stream() << to_json(record, provenance());
  file.commit();
}

}  // namespace experiments
