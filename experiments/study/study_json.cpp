#include "experiments/study/study_json.h"

#include <nlohmann/json.hpp>

#include "experiments/method/result_json.h"

namespace experiments {
namespace {

Json methods_json(const StudyOutline& study) {
  Json json = Json::object();
  for (const auto& [name, method] : study.methods) json[name] = method;
  return json;
}

}  // namespace

StudyOutline outline(const Study& study) {
  StudyOutline found{study, {}, {}};
  for (const Entrant& entrant : study.entrants) {
    found.methods.emplace_back(entrant.name, entrant.method->name);
  }
  for (const Trial& trial : trials(study)) {
    found.trials.push_back({trial_id(study, trial), study.scenarios[trial.scenario].name,
                            study.entrants[trial.entrant].name, trial.replicate});
  }
  return found;
}

std::string studies_json(const std::vector<StudyOutline>& studies) {
  Json json = Json::array();
  for (const StudyOutline& study : studies) {
    json.push_back({{"study", study.name},
                    {"title", study.title},
                    {"trials", study.trials.size()},
                    {"frames", study.frames},
                    {"methods", methods_json(study)}});
  }
  return json.dump(1) + "\n";
}

std::string trials_json(const StudyOutline& study) {
  Json files = {{study.file.path, study.file.hash}};
  for (const ReadFile& file : study.scenario_files) files[file.path] = file.hash;
  Json all = Json::array();
  for (const StudyOutline::Trial& trial : study.trials) {
    all.push_back({{"id", trial.id},
                   {"scenario", trial.scenario},
                   {"method", trial.method},
                   {"replicate", trial.replicate}});
  }
  return dump({{"study", study.name},
               {"file", study.file.path},
               {"frames", study.frames},
               {"methods", methods_json(study)},
               {"files", std::move(files)},
               {"trials", std::move(all)}});
}

}  // namespace experiments
