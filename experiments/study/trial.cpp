#include "experiments/study/trial.h"

#include <exception>
#include <optional>
#include <span>
#include <utility>

#include "datasets/files/partial_file.h"
#include "datasets/files/text.h"
#include "datasets/scenario/simulation.h"
#include "experiments/study/seeds.h"

namespace experiments {
namespace {

void write(const std::string& text, const std::filesystem::path& path) {
  datasets::PartialFile file(path);
  file.stream() << text;
  file.commit();
}

/// A trial that is to run.
struct PreparedTrial {
  TrialRecord record;
  const Method* method = nullptr;
  datasets::Scenario scenario;

  bool same_world(const PreparedTrial& other) const {
    return record.scenario_file_hash == other.record.scenario_file_hash &&
           record.scenario_seed == other.record.scenario_seed;
  }
};

PreparedTrial prepared(const TrialRequest& request, const Study& study) {
  const Trial trial = find_trial(study, request.id);
  const Entrant& entrant = study.entrants[trial.entrant];
  PreparedTrial found{.record = {},
                      .method = entrant.method,
                      .scenario = scenario_at(study, trial.scenario, trial.point)};
  TrialRecord& record = found.record;
  record.study = study.name;
  record.id = request.id;
  record.scenario = found.scenario.name;
  record.method = entrant.name;
  record.replicate = trial.replicate;
  record.point = study.points[trial.point];
  record.frames = study.frames;
  record.parameters = trial_parameters(study, trial);
  record.scenario_seed = scenario_seed(found.scenario.name, trial.replicate);
  record.filter_seed = record.parameters.execution.seed;
  record.files = {study.file, study.scenario_files[trial.scenario]};
  record.scenario_file_hash = datasets::scenario_hash(found.scenario);
  record.plugin = plugin_of(*entrant.method);
  record.serial = request.serial;
  record.command = repeating_command(request, record.replicate, record.frames);
  record.error = request.failure;
  return found;
}

/// Calls `step`; what it throws becomes the trial's error.
template <class Step>
void guarded(TrialRecord& record, Step&& step) {
  if (record.error) return;
  try {
    step();
  } catch (const std::exception& error) {
    record.error = datasets::single_line(error.what());
  }
}

/// Trials in one world, side by side. One that fails leaves the others alone.
void run_in_world(std::span<PreparedTrial> trials, bool series) {
  std::optional<datasets::Simulation> simulation;
  std::vector<std::optional<MethodEvaluation>> evaluations(trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const PreparedTrial& trial = trials[i];
    guarded(trials[i].record, [&] {
      if (!simulation) {
        simulation.emplace(trial.scenario, trial.record.scenario_seed, trial.record.frames);
      }
      evaluations[i].emplace(*trial.method, trial.record.parameters,
                             EvaluationOptions{.frames = {}, .series = series, .observer = {}});
    });
  }
  datasets::Frame frame;
  while (simulation && simulation->next(frame)) {
    for (std::size_t i = 0; i < trials.size(); ++i) {
      guarded(trials[i].record, [&] { evaluations[i]->add(frame); });
    }
  }
  for (std::size_t i = 0; i < trials.size(); ++i) {
    guarded(trials[i].record, [&] { trials[i].record.evaluation = evaluations[i]->finish(); });
  }
}

}  // namespace

std::string repeating_command(const TrialRequest& request, std::int64_t seeds,
                              std::int64_t frames) {
  std::vector<std::string> words = {"ldm"};
  if (request.data_dir) words.insert(words.end(), {"--data-dir", *request.data_dir});
  for (const std::string& file : request.plugins) words.insert(words.end(), {"--plugin", file});
  words.insert(words.end(), {"trial", request.study, request.id, "--seeds", std::to_string(seeds),
                             "--frames", std::to_string(frames), "-o", request.id + ".json"});
  for (const std::string& method : request.options.methods) {
    words.insert(words.end(), {"--method", method});
  }
  return datasets::command_line(words);
}

void run_trials(const TrialRequest& request, const std::vector<std::string>& ids,
                const std::function<void(const TrialRecord&)>& done) {
  const DataFolders folders(request.data_dir);
  const Study study =
      read_study(folders.studies.file(request.study), folders.scenarios, request.options);
  std::vector<PreparedTrial> trials;
  for (const std::string& id : ids) {
    TrialRequest one = request;
    one.id = id;
    trials.push_back(prepared(one, study));
  }
  for (std::size_t begin = 0, end; begin < trials.size(); begin = end) {
    end = begin + 1;
    while (!request.serial && end < trials.size() && trials[end].same_world(trials[begin])) ++end;
    const std::span<PreparedTrial> group(trials.data() + begin, end - begin);
    run_in_world(group, study.series);
    for (const PreparedTrial& trial : group) done(trial.record);
    for (PreparedTrial& trial : group) trial.record.evaluation = {};
  }
}

void write_record(const TrialRecord& record, const std::filesystem::path& path) {
  const std::string series = series_json(record);
  if (!series.empty()) {
    std::filesystem::path beside = path;
    write(series, beside.replace_extension(".series.json"));
  }
  write(to_json(record, provenance(), series.size()), path);
}

}  // namespace experiments
