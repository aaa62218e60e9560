#include "experiments/avoidance/flight_study.h"

#include <algorithm>
#include <exception>

#include "datasets/files/at_place.h"
#include "datasets/files/partial_file.h"
#include "datasets/files/text.h"
#include "datasets/files/toml_reader.h"
#include "datasets/hash.h"
#include "experiments/avoidance/flight_record.h"
#include "experiments/study/seeds.h"

namespace experiments {
namespace {

using datasets::at_place;
using datasets::TomlTable;

void read_worlds(const TomlTable& file, const DataFolder& corridors, FlightStudy& study) {
  read_scenarios(file, "worlds", corridors, study);
  for (datasets::Scenario& world : study.scenarios) {
    if (study.frames > world.frames) {
      throw ldm::InvalidInput(file.place("worlds") + ": frames = " + std::to_string(study.frames) +
                              ": allowed: at most the " + std::to_string(world.frames) + " of " +
                              world.name);
    }
    world.frames = study.frames;
  }
}

void read_arms(const TomlTable& file, const StudyOptions& options, FlightStudy& study) {
  for (const char* key : {"controls", "methods"}) {
    for (const std::string& name : file.texts(key)) {
      at_place(file.place(key), [&] { find_arm(name); });
      study.arms.push_back(name);
    }
  }
  if (!options.methods.empty()) study.arms = options.methods;
  for (const std::string& name : study.arms) {
    find_arm(name);
    if (std::count(study.arms.begin(), study.arms.end(), name) > 1) {
      throw ldm::InvalidInput(file.place("methods") + ": " + name +
                              " comes twice: allowed: each arm once");
    }
  }
}

/// That every world of every point is a corridor at all.
void check_worlds(const FlightStudy& study) {
  const Point& first = study.points.front();
  const bool varies = std::any_of(first.begin(), first.end(), [](const Setting& setting) {
    return !scenario_key(setting).empty();
  });
  for (std::size_t world = 0; world < study.scenarios.size(); ++world) {
    for (std::size_t point = 0; point < (varies ? study.points.size() : 1); ++point) {
      draw_corridor(scenario_at(study, world, point), 1);
    }
  }
}

/// That each value fits the arms that use it, and one does.
void check_values(const FlightStudy& study) {
  for (const std::string& arm : study.arms) {
    FlightSettings scratch = flight_settings(arm);
    for (const Setting& setting : study.settings) {
      if (uses(scratch, setting.name)) apply(setting, scratch);
    }
    for (const Point& point : study.points) {
      for (const Setting& setting : point) {
        if (uses(scratch, setting.name)) apply(setting, scratch);
      }
    }
  }
  const auto check_used = [&](const Setting& setting) {
    if (!scenario_key(setting).empty()) return;
    const bool used = std::any_of(study.arms.begin(), study.arms.end(), [&](const auto& arm) {
      return uses(flight_settings(arm), setting.name);
    });
    if (!used) refuse(setting, "values that an arm of the study uses");
  };
  for (const Setting& setting : study.settings) check_used(setting);
  for (const Setting& setting : study.points.front()) check_used(setting);
}

FlightSettings trial_settings(const FlightStudy& study, const FlightTrial& trial) {
  FlightSettings settings = flight_settings(study.arms[trial.arm]);
  for (const Settings* all : {&study.settings, &study.points[trial.point]}) {
    for (const Setting& setting : *all) {
      if (uses(settings, setting.name)) apply(setting, settings);
    }
  }
  settings.map.execution.seed = filter_seed(study.name, describe(study.points[trial.point]),
                                            trial.replicate, study.arms[trial.arm]);
  return settings;
}

std::uint64_t corridor_seed(const datasets::Scenario& world, std::int64_t replicate) {
  return datasets::hash({"corridor", world.name, std::to_string(replicate)});
}

/// Flies it; what is thrown on the way becomes its error.
void fly_trial(FlightRecord& record) {
  try {
    const FlightTask task = flight_task(record.world, record.scenario_seed, record.settings);
    const Arm& arm = record.settings.arm;
    record.flight = fly(task, *arm.sight(record.settings.map, task.corridor));
    record.scores = flight_scores(task, record.flight);
  } catch (const std::exception& error) {
    record.error = datasets::single_line(error.what());
  }
}

}  // namespace

bool is_flight_study(const std::filesystem::path& file) {
  return TomlTable::open(file).has("controls");
}

FlightStudy read_flight_study(const std::filesystem::path& path, const DataFolder& corridors,
                              const StudyOptions& options) {
  const TomlTable file = TomlTable::open(path);
  FlightStudy study;
  read_head(file, path, corridors, options, study);
  study.first_seed = file.integer("first_seed", {.min = 1, .max = 100000}, 1);
  read_arms(file, options, study);
  read_worlds(file, corridors, study);
  read_set(file, study);
  read_sweep(file, study);
  file.reject_unknown_keys();
  check_values(study);
  check_worlds(study);
  return study;
}

std::vector<FlightTrial> flight_trials(const FlightStudy& study) {
  std::vector<FlightTrial> all;
  for (std::int64_t k = 0; k < study.seeds; ++k) {
    for (std::size_t world = 0; world < study.scenarios.size(); ++world) {
      for (std::size_t point = 0; point < study.points.size(); ++point) {
        for (std::size_t arm = 0; arm < study.arms.size(); ++arm) {
          const std::int64_t replicate = study.first_seed + k;
          all.push_back({trial_id(study.scenarios[world].name, study.arms[arm],
                                  study.swept() ? std::optional(point) : std::nullopt, replicate),
                         world, arm, point, replicate});
        }
      }
    }
  }
  return all;
}

StudyOutline outline(const FlightStudy& study) {
  StudyOutline found{study, {}, {}};
  for (const std::string& name : study.arms) {
    const Arm arm = find_arm(name);
    found.methods.emplace_back(name, arm.method != nullptr ? std::string(arm.method->name) : name);
  }
  for (const FlightTrial& trial : flight_trials(study)) {
    found.trials.push_back(
        {trial.id, study.scenarios[trial.world].name, study.arms[trial.arm], trial.replicate});
  }
  return found;
}

FlightTask flight_task(const datasets::Scenario& world, std::uint64_t seed,
                       const FlightSettings& settings) {
  return {.corridor = draw_corridor(world, seed),
          .sensor = world.sensor,
          .noise_seed = seed,
          .planner = settings.planner,
          .delay = settings.delay};
}

std::optional<std::string> run_flight_trial(const TrialRequest& request,
                                            const std::filesystem::path& path) {
  const DataFolders folders(request.data_dir);
  const FlightStudy study =
      read_flight_study(folders.studies.file(request.study), folders.corridors, request.options);
  const std::vector<FlightTrial> all = flight_trials(study);
  const auto trial = std::find_if(all.begin(), all.end(),
                                  [&](const FlightTrial& t) { return t.id == request.id; });
  if (trial == all.end()) {
    std::vector<std::string> ids(all.size());
    std::transform(all.begin(), all.end(), ids.begin(),
                   [](const FlightTrial& known) { return known.id; });
    refuse_trial(study.name, request.id, ids);
  }
  FlightRecord record;
  record.command = repeating_command(request, study.seeds, study.frames);
  record.study = study.name;
  record.id = trial->id;
  record.point = study.points[trial->point];
  record.world = scenario_at(study, trial->world, trial->point);
  record.replicate = trial->replicate;
  record.scenario_seed = corridor_seed(record.world, trial->replicate);
  record.settings = trial_settings(study, *trial);
  record.files = {study.file, study.scenario_files[trial->world]};
  record.serial = request.serial;
  record.error = request.failure;
  if (!record.error) fly_trial(record);
  datasets::PartialFile file(path);
  file.stream() << to_json(record, provenance());
  file.commit();
  return record.error;
}

}  // namespace experiments
