#include "experiments/study/study.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>

#include "datasets/files/at_place.h"
#include "datasets/files/text.h"
#include "datasets/hash.h"
#include "experiments/study/seeds.h"

namespace experiments {
namespace {

using datasets::at_place;
using datasets::TomlTable;

/// Names become parts of ids and of file names; dots part them.
void add_entrant(Study& study, const std::string& place, Entrant entrant) {
  check_plain_name(place, entrant.name);
  for (const Entrant& other : study.entrants) {
    if (other.name == entrant.name) {
      throw ldm::InvalidInput(place + ": " + entrant.name +
                              " comes twice: allowed: each method and variant once");
    }
  }
  study.entrants.push_back(std::move(entrant));
}

/// `find_method` with the place of the name in front of its message.
const Method& method_at(const std::string& place, const std::string& name) {
  try {
    return find_method(name);
  } catch (const ldm::InvalidInput& error) {
    throw ldm::InvalidInput(place + ": " + error.what());
  }
}

void read_entrants(const TomlTable& file, Study& study) {
  if (file.has("methods")) {
    const std::string place = file.place("methods");
    for (const std::string& name : file.texts("methods", {.min = 1})) {
      add_entrant(study, place, {name, &method_at(place, name), {}});
    }
  }
  for (const TomlTable& variant : file.tables("variant")) {
    Entrant entrant;
    entrant.name = variant.text("name");
    entrant.method = &method_at(variant.place("method"), variant.text("method"));
    entrant.settings = settings_of(variant.table("set"));
    add_entrant(study, variant.place("name"), std::move(entrant));
  }
  if (study.entrants.empty()) {
    throw ldm::InvalidInput(file.place() +
                            ": methods: allowed: at least one method or [[variant]]");
  }
}

void replace_entrants(const std::vector<std::string>& methods, Study& study) {
  study.entrants.clear();
  for (const std::string& name : methods) {
    add_entrant(study, "--method", {name, &method_at("--method", name), {}});
  }
}

/// A value for all trials must mean something to one of their methods at least.
void check_for_all(const Study& study, const Setting& setting) {
  if (setting.name == "execution.seed") {
    refuse(setting, "no value: the seed follows from study, point, replicate and method");
  }
  ldm::Parameters scratch;
  apply(setting, scratch);
  const bool used =
      std::any_of(study.entrants.begin(), study.entrants.end(),
                  [&](const Entrant& entrant) { return uses(*entrant.method, setting.name); });
  if (!used) refuse(setting, "parameters that a method of the study uses");
}

/// The parameters of `[set]` and, each value once as points repeat them, of the sweep.
void check_settings(const Study& study) {
  for (const Setting& setting : study.settings) check_for_all(study, setting);
  std::set<std::string> checked;
  for (const Point& point : study.points) {
    for (const Setting& setting : point) {
      const bool is_new = checked.insert(describe({setting})).second;
      if (is_new && scenario_key(setting).empty()) check_for_all(study, setting);
    }
  }
}

void check_frames(const Study& study, const datasets::Scenario& scenario) {
  if (study.frames <= scenario.frames) return;
  throw ldm::InvalidInput("study " + study.name + ": frames = " + std::to_string(study.frames) +
                          ": allowed: at most the " + std::to_string(scenario.frames) + " of " +
                          scenario.name);
}

/// Every scenario of every point, and every variant, can be made.
void check_trials(const Study& study) {
  for (const Entrant& entrant : study.entrants) {
    ldm::Parameters scratch = default_parameters(*entrant.method);
    for (const Setting& setting : entrant.settings) {
      if (setting.name == "execution.seed") check_for_all(study, setting);
      apply(setting, *entrant.method, scratch);
    }
  }
  for (std::size_t scenario = 0; scenario < study.scenarios.size(); ++scenario) {
    for (std::size_t point = 0; point < study.points.size(); ++point) {
      check_frames(study, scenario_at(study, scenario, point));
    }
  }
}

}  // namespace

void check_plain_name(const std::string& place, const std::string& name) {
  const bool good = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  if (!good) {
    throw ldm::InvalidInput(place + ": name \"" + name + "\": allowed: letters, digits, _ and -");
  }
}

ReadFile read_file(const std::filesystem::path& path, const DataFolder& folder) {
  const auto data = std::filesystem::weakly_canonical(folder.path / ".." / "..");
  const auto file = std::filesystem::weakly_canonical(path);
  const auto relative = file.lexically_relative(data);
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  const bool inside = !relative.empty() && *relative.begin() != "..";
  return {(inside ? relative : file).string(), datasets::hex(datasets::hash({content.str()}))};
}

void read_head(const TomlTable& file, const std::filesystem::path& path,
               const DataFolder& scenarios, const StudyOptions& options, StudyBase& study) {
  study.name = path.stem().string();
  check_plain_name(path.string(), study.name);
  study.file = read_file(path, scenarios);
  study.title = file.text("title");
  study.seeds = file.integer("seeds", {.min = 1, .max = 100000});
  study.frames = file.integer("frames", {.min = 1, .max = 1000000});
  if (options.seeds) study.seeds = *options.seeds;
  if (options.frames) study.frames = *options.frames;
}

void read_scenarios(const TomlTable& file, std::string_view key, const DataFolder& folder,
                    StudyBase& study) {
  for (const std::string& name : file.texts(key, {.min = 1})) {
    at_place(file.place(key), [&] {
      const std::filesystem::path path = folder.file(name);
      study.scenarios.push_back(datasets::read_scenario(path));
      study.scenario_files.push_back(read_file(path, folder));
      const std::string& added = study.scenarios.back().name;
      check_plain_name(path.string(), added);
      const auto same = [&](const datasets::Scenario& s) { return s.name == added; };
      if (std::count_if(study.scenarios.begin(), study.scenarios.end(), same) > 1) {
        throw ldm::InvalidInput(added + " comes twice: allowed: each of the " + std::string(key) +
                                " once");
      }
    });
  }
}

void read_set(const TomlTable& file, StudyBase& study) {
  if (!file.has("set")) return;
  for (const Setting& setting : settings_of(file.table("set"))) {
    if (scenario_key(setting).empty()) {
      study.settings.push_back(setting);
    } else {
      for (datasets::Scenario& scenario : study.scenarios) apply(setting, scenario);
    }
  }
}

void read_sweep(const TomlTable& file, StudyBase& study) {
  study.points = {Point{}};
  if (file.has("sweep")) study.points = read_points(file.table("sweep"));
}

Study read_study(const std::filesystem::path& path, const DataFolder& scenarios,
                 const StudyOptions& options) {
  const TomlTable file = TomlTable::open(path);
  Study study;
  read_head(file, path, scenarios, options, study);
  study.series = file.boolean("series", false);
  read_entrants(file, study);
  read_scenarios(file, "scenarios", scenarios, study);
  read_set(file, study);
  read_sweep(file, study);
  check_settings(study);
  file.reject_unknown_keys();
  // Only now: a swept parameter may mean nothing to a method that is held against the study's.
  if (!options.methods.empty()) replace_entrants(options.methods, study);
  check_trials(study);
  return study;
}

std::vector<Trial> trials(const Study& study) {
  std::vector<Trial> all;
  all.reserve(study.trial_count());
  for (std::int64_t replicate = 1; replicate <= study.seeds; ++replicate) {
    for (std::size_t scenario = 0; scenario < study.scenarios.size(); ++scenario) {
      for (std::size_t point = 0; point < study.points.size(); ++point) {
        for (std::size_t entrant = 0; entrant < study.entrants.size(); ++entrant) {
          all.push_back({scenario, entrant, point, replicate});
        }
      }
    }
  }
  return all;
}

std::string trial_id(const std::string& scenario, const std::string& method,
                     std::optional<std::size_t> point, std::int64_t replicate) {
  char number[32];
  std::string id = scenario + "." + method;
  if (point) {
    std::snprintf(number, sizeof number, ".p%02zu", *point + 1);
    id += number;
  }
  std::snprintf(number, sizeof number, ".s%03lld", static_cast<long long>(replicate));
  return id + number;
}

std::string trial_id(const Study& study, const Trial& trial) {
  return trial_id(study.scenarios[trial.scenario].name, study.entrants[trial.entrant].name,
                  study.swept() ? std::optional(trial.point) : std::nullopt, trial.replicate);
}

void refuse_trial(const std::string& study, std::string_view id,
                  const std::vector<std::string>& known) {
  throw ldm::InvalidInput("study " + study + " has no trial " + std::string(id) +
                          ": allowed: an id that `ldm trials " + study + "` lists" +
                          datasets::did_you_mean(id, known));
}

Trial find_trial(const Study& study, std::string_view id) {
  const std::vector<Trial> all = trials(study);
  std::vector<std::string> ids;
  for (const Trial& trial : all) {
    ids.push_back(trial_id(study, trial));
    if (ids.back() == id) return trial;
  }
  refuse_trial(study.name, id, ids);
}

ldm::Parameters trial_parameters(const Study& study, const Trial& trial) {
  const Entrant& entrant = study.entrants[trial.entrant];
  const Point& point = study.points[trial.point];
  ldm::Parameters parameters = default_parameters(*entrant.method);
  for (const Settings* settings : {&study.settings, &entrant.settings, &point}) {
    for (const Setting& setting : *settings) {
      if (scenario_key(setting).empty()) apply(setting, parameters);
    }
  }
  parameters.execution.seed =
      filter_seed(study.name, describe(point), trial.replicate, entrant.name);
  return parameters;
}

datasets::Scenario scenario_at(const StudyBase& study, std::size_t scenario, std::size_t point) {
  datasets::Scenario found = study.scenarios[scenario];
  for (const Setting& setting : study.points[point]) {
    if (!scenario_key(setting).empty()) apply(setting, found);
  }
  return found;
}

}  // namespace experiments
