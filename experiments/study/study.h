#pragma once
/// Studies as data: a TOML file, and the trials it stands for (no paper section).
///
///     title = "Table 1: occupancy accuracy"
///     scenarios = ["scenario1", "scenario2"]
///     methods = ["ldm", "circular_buffer"]
///     seeds = 10               # replicates 1 to 10
///     frames = 1200
///     series = true            # keep the velocity series (default false)
///     [set]                    # for all trials: parameters, or `scenario.` values
///     "particles.count" = 100000
///     [sweep]                  # see sweep.h
///     [[variant]]              # a method with parameters of its own, under its own name
///     name = "no_survival"
///     method = "ldm"
///     set = {"survival.enabled" = false}
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/scenario/scenario.h"
#include "experiments/method/data_folders.h"
#include "experiments/method/methods.h"
#include "experiments/study/sweep.h"

namespace experiments {

/// A method of the table, or a variant of one.
struct Entrant {
  std::string name;
  const Method* method = nullptr;
  Settings settings;  ///< the variant's own
};

/// A file that a study was read from.
struct ReadFile {
  std::string path;  ///< relative to the data folder; absolute where it lies outside
  std::string hash;  ///< of its bytes, in hex
};

/// The file as it is now.
/// @param folder of a kind, such as `datasets/scenarios`, in the data folder
ReadFile read_file(const std::filesystem::path& file, const DataFolder& folder);

/// What a study of every kind has.
struct StudyBase {
  std::string name;  ///< stem of its file
  std::string title;
  ReadFile file;
  std::vector<ReadFile> scenario_files;       ///< one for each of `scenarios`
  std::vector<datasets::Scenario> scenarios;  ///< with the values of `[set]`
  Settings settings;                          ///< parameters of `[set]`
  std::vector<Point> points;                  ///< one empty point without a sweep
  std::int64_t seeds = 0;
  std::int64_t frames = 0;

  bool swept() const { return !points.front().empty(); }
};

struct Study : StudyBase {
  std::vector<Entrant> entrants;  ///< methods, then variants
  bool series = false;

  std::size_t trial_count() const {
    return scenarios.size() * entrants.size() * points.size() * static_cast<std::size_t>(seeds);
  }
};

/// What a command line may change of a study.
struct StudyOptions {
  std::optional<std::int64_t> seeds;
  std::optional<std::int64_t> frames;
  std::vector<std::string> methods = {};  ///< instead of the study's methods and variants
};

/// Names of studies, worlds and methods become those of files and trials.
/// @throws ldm::InvalidInput beginning with `place` unless it is of letters, digits, _ and -.
void check_plain_name(const std::string& place, const std::string& name);

/// Parts of a study's file, of every kind.
/// @throws ldm::InvalidInput with file, line, key, value and what is allowed.
void read_head(const datasets::TomlTable& file, const std::filesystem::path& path,
               const DataFolder& scenarios, const StudyOptions& options, StudyBase& study);
void read_scenarios(const datasets::TomlTable& file, std::string_view key,
                    const DataFolder& scenarios, StudyBase& study);
/// `[set]`, after the scenarios that it changes.
void read_set(const datasets::TomlTable& file, StudyBase& study);
void read_sweep(const datasets::TomlTable& file, StudyBase& study);

/// Reads and checks all of it: every value of every point fits every scenario and method.
/// @throws ldm::InvalidInput with file, line, key, value and what is allowed.
Study read_study(const std::filesystem::path& file, const DataFolder& scenarios,
                 const StudyOptions& options = {});

/// Positions in the lists of the study, and the replicate from 1.
struct Trial {
  std::size_t scenario = 0, entrant = 0, point = 0;
  std::int64_t replicate = 1;
};

/// All trials, replicate by replicate: a study cut short has all methods on fewer seeds.
std::vector<Trial> trials(const Study& study);

/// `scenario1.ldm.s001`; with the point of a sweep, its position from 0, `scenario1.ldm.p02.s001`.
std::string trial_id(const std::string& scenario, const std::string& method,
                     std::optional<std::size_t> point, std::int64_t replicate);
std::string trial_id(const Study& study, const Trial& trial);

/// @throws ldm::InvalidInput that the study has no such trial; `known` are the ids that it has.
[[noreturn]] void refuse_trial(const std::string& study, std::string_view id,
                               const std::vector<std::string>& known);

/// @throws ldm::InvalidInput if the study has no such trial.
Trial find_trial(const Study& study, std::string_view id);

/// Complete parameters: defaults, the method's, `[set]`, the variant's, the point's; later wins.
/// `execution.seed` is the trial's filter seed.
ldm::Parameters trial_parameters(const Study& study, const Trial& trial);

/// A scenario at a point, by their positions in the lists of the study.
datasets::Scenario scenario_at(const StudyBase& study, std::size_t scenario, std::size_t point);

}  // namespace experiments
