#include "experiments/study/study_json.h"

#include <nlohmann/json.hpp>

#include "experiments/method/result_json.h"

namespace experiments {
namespace {

Json methods_json(const Study& study) {
  Json json = Json::object();
  for (const Entrant& entrant : study.entrants) json[entrant.name] = entrant.method->name;
  return json;
}

}  // namespace

std::string studies_json(const std::vector<Study>& studies) {
  Json json = Json::array();
  for (const Study& study : studies) {
    json.push_back({{"study", study.name},
                    {"title", study.title},
                    {"trials", study.trial_count()},
                    {"frames", study.frames},
                    {"methods", methods_json(study)}});
  }
  return json.dump(1) + "\n";
}

std::string trials_json(const Study& study) {
  Json files = {{study.file.path, study.file.hash}};
  for (const ReadFile& file : study.scenario_files) files[file.path] = file.hash;
  Json all = Json::array();
  for (const Trial& trial : trials(study)) {
    all.push_back({{"id", trial_id(study, trial)},
                   {"scenario", study.scenarios[trial.scenario].name},
                   {"method", study.entrants[trial.entrant].name},
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
