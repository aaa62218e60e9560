/// The program `ldm`: command line to calls. Exit codes: 0 good, 1 the run failed, 2 bad input.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "datasets/files/text.h"
#include "experiments/avoidance/flight_study.h"
#include "experiments/avoidance/fly.h"
#include "experiments/completion.h"
#include "experiments/listings.h"
#include "experiments/method/plugins.h"
#include "experiments/method/provenance.h"
#include "experiments/runs/render.h"
#include "experiments/runs/run.h"
#include "experiments/runs/score.h"
#include "experiments/runs/simulate.h"
#include "experiments/runs/view.h"
#include "experiments/study/trial.h"

namespace {

using experiments::DataFolders;

enum ExitCode { kGood = 0, kFailed = 1, kBadInput = 2 };

int complain(std::string_view message, ExitCode code) {
  std::cerr << "ldm: " << datasets::single_line(message) << '\n';
  return code;
}

std::string version() {
  const experiments::Provenance p = experiments::provenance();
  return "ldm " + p.version + " (commit " + p.commit + (p.dirty ? ", changed" : "") + ", binary " +
         p.binary + ")";
}

bool is_number(const std::string& text, double& value) {
  return CLI::detail::lexical_cast(text, value) && std::isfinite(value);
}
/// For `check`: empty, or what is wrong. CLI11's own name the largest double as their bound.
std::string at_least_zero(const std::string& text) {
  double value = 0;
  return is_number(text, value) && value >= 0 ? "" : text + ": allowed: a number from 0 on";
}
std::string positive(const std::string& text) {
  double value = 0;
  return is_number(text, value) && value > 0 ? "" : text + ": allowed: a number above 0";
}

/// The command line: options land in the members, `action` is what the chosen subcommand does.
class CommandLine {
 public:
  explicit CommandLine(std::vector<std::string> words) : words_(std::move(words)) {
    app_.require_subcommand(1);
    app_.footer(
        "Names and options by Tab: experiments/shell/ldm.bash, which is installed for Bash.");
    app_.set_version_flag("--version", version);
    app_.add_option("--data-dir", data_dir_,
                    "folder with datasets/scenarios and experiments/studies");
    repeatable(
        app_.add_option("--plugin", plugins_, "shared object with more methods; may be repeated"));
    app_.fallthrough();  // these may also follow the subcommand
    app_.get_formatter()->column_width(34);
    add_lists();
    add_info();
    add_simulate();
    add_run();
    add_score();
    add_render();
    add_view();
    add_fly();
    add_trial();
  }

  int execute(int argc, char** argv) {
    if (words_.size() == 1) {
      std::cout << app_.help();
      return kGood;
    }
    if (words_[1] == "complete") return complete({words_.begin() + 2, words_.end()});
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& help) {
      return app_.exit(help);
    } catch (const CLI::ParseError& error) {
      return complain(reason(error) + " (see ldm --help)", kBadInput);
    }
    for (const std::string& file : plugins_) experiments::load_plugin(file);
    return action_();
  }

 private:
  /// CLI11 calls a misspelt subcommand a missing one, and has no idea what was meant.
  std::string reason(const CLI::ParseError& error) const {
    const std::vector<std::string> unknown = app_.remaining(true);
    if (unknown.empty()) return error.what();
    const std::vector<CLI::App*> chosen = app_.get_subcommands();
    std::vector<std::string> known;
    if (chosen.empty()) {
      for (const CommandWords& command : commands()) known.push_back(command.name);
      return "unknown subcommand " + unknown.front() + ": allowed: " + datasets::joined(known) +
             datasets::did_you_mean(unknown.front(), known);
    }
    for (const CommandWords& words : {words_of(app_), words_of(*chosen.front())}) {
      known.insert(known.end(), words.flags.begin(), words.flags.end());
      known.insert(known.end(), words.options.begin(), words.options.end());
    }
    // What follows an unknown option may stand before it in CLI11's list.
    const auto option = std::find_if(unknown.begin(), unknown.end(),
                                     [](const std::string& word) { return word.starts_with('-'); });
    if (option == unknown.end()) return error.what();
    return error.what() + datasets::did_you_mean(option->substr(0, option->find('=')), known);
  }

  using CommandWords = experiments::CommandWords;

  static CommandWords words_of(const CLI::App& app) {
    CommandWords words{.name = app.get_name(), .flags = {}, .options = {}, .positionals = {}};
    for (const CLI::Option* option : app.get_options()) {
      if (option->get_snames().empty() && option->get_lnames().empty()) {
        words.positionals.push_back(option->get_single_name());
      }
      std::vector<std::string>& all =
          option->get_items_expected_max() > 0 ? words.options : words.flags;
      for (const std::string& name : option->get_snames()) all.push_back("-" + name);
      for (const std::string& name : option->get_lnames()) all.push_back("--" + name);
    }
    return words;
  }

  std::vector<CommandWords> commands() const {
    std::vector<CommandWords> all;
    for (const CLI::App* command : app_.get_subcommands({})) all.push_back(words_of(*command));
    return all;
  }

  /// `ldm complete WORD...`, for shells: a line for each word that the last may become.
  int complete(const std::vector<std::string>& words) const {
    for (const std::string& word :
         experiments::completions(words_of(app_), commands(), words, folders())) {
      std::cout << word << '\n';
    }
    return kGood;
  }

  CLI::App* add(const std::string& name, const std::string& help, const std::string& example,
                std::function<int()> action) {
    CLI::App* command = app_.add_subcommand(name, help);
    command->footer("Example: " + example);
    command->callback([this, action = std::move(action)] { action_ = action; });
    return command;
  }

  /// One value each time it is given.
  static void repeatable(CLI::Option* option) {
    option->expected(1)->allow_extra_args(false)->multi_option_policy(
        CLI::MultiOptionPolicy::TakeAll);
  }

  /// A subcommand that prints.
  CLI::App* add_list(const std::string& name, const std::string& help, const std::string& example,
                     std::function<void()> print) {
    return add(name, help, example, [print = std::move(print)] {
      print();
      return std::cout.flush() ? kGood : complain("standard output cannot be written", kFailed);
    });
  }

  void add_lists() {
    add_list("methods", "list the methods", "ldm methods", [this] {
      experiments::list_methods(json_, std::cout);
    })->add_flag("--json", json_, "with what they read, for programs");
    add_list("scenarios", "list the scenarios", "ldm scenarios",
             [this] { experiments::list_scenarios(folders(), std::cout); });
    add_list("studies", "list the studies with their number of trials", "ldm studies", [this] {
      experiments::list_studies(folders(), json_, std::cout);
    })->add_flag("--json", json_, "with their methods, for programs");
    CLI::App* parameters =
        add_list("parameters", "list the parameters of methods and recordings, or of a scenario",
                 "ldm parameters circular_buffer",
                 [this] { experiments::list_parameters(of_, folders(), json_, std::cout); });
    parameters->add_option("OF", of_,
                           "a method or scenario, with its values; or the word scenario: what "
                           "any of them may say");
    parameters->add_flag("--json", json_, "for programs");
    CLI::App* trials =
        add_list("trials", "list the trials of a study", "ldm trials table1 --seeds 2", [this] {
          experiments::list_trials(trial_.study, trial_.options, folders(), json_, std::cout);
        });
    add_study_options(trials);
    trials->add_flag("--json", json_, "with what made them, for programs");
  }

  void add_info() {
    CLI::App* command = add_list(
        "info", "tell what is in a recording, and what of it would be taken", "ldm info drive.bag",
        [this] { experiments::list_recording(info_, folders(), std::cout); });
    command->add_option("FILE", info_.input, "recording (docs/recordings.md)")->required();
    repeatable(
        command->add_option("--set", info_.settings, "name=value of a parameter; may be repeated"));
    add_recording_options(command, info_);
  }

  void add_simulate() {
    CLI::App* command = add("simulate", "record a scenario as a log, with its truth beside it",
                            "ldm simulate scenario1 --seed 1 --frames 100 -o out.rawlog", [this] {
                              experiments::simulate(simulate_, folders());
                              return kGood;
                            });
    command->add_option("SCENARIO", simulate_.scenario, "name or .toml file")->required();
    command->add_option("--seed", simulate_.seed, "of the world")->capture_default_str();
    repeatable(
        command->add_option("--set", simulate_.settings, "scenario.NAME=VALUE; may be repeated"));
    command->add_option("--frames", simulate_.frames, "default: the scenario's")->check(positive);
    command->add_option("-o,--output", simulate_.output, "FILE.rawlog")->required();
  }

  void add_run() {
    CLI::App* command =
        add("run", "run a method; writes clusters.csv, frames.csv, timing.csv and summary.json",
            "ldm run ldm scenario1 -o out --set particles.count=50000 --frames 300", [this] {
              run_.command = datasets::command_line(words_);
              experiments::run(run_, folders());
              return kGood;
            });
    add_method_and_input(command, run_);
    command->add_option("-o,--output", run_.output, "folder, made if it is missing")->required();
    command->add_option("--frames", run_.frames, "stop after so many")->check(positive);
    command
        ->add_option("--rate", run_.rate,
                     "play at so many times the log's own speed, and tell which frames came late")
        ->check(positive);
    command
        ->add_option("--save-frames", run_.save.frames,
                     "frames whose occupied and free voxels go to OUTPUT/maps, as in 100,200")
        ->delimiter(',')
        ->check(at_least_zero);
    command->add_option("--save-as", run_.save.formats, "ply, bt (OctoMap), or ply,bt")
        ->delimiter(',')
        ->capture_default_str();
  }

  void add_score() {
    CLI::App* command =
        add_list("score",
                 "hold the clusters of a run against a reference; writes score.csv and "
                 "score.json into RUN",
                 "ldm score out --truth flight.truth.csv",
                 [this] { experiments::score_run(score_, std::cout); });
    command->add_option("RUN", score_.run, "output folder of `ldm run`")->required();
    command->add_option("--truth", score_.truth, "table of the true objects (docs/scores.md)")
        ->required();
    command
        ->add_option("--gate", score_.gate,
                     "how far from an object's box the centroid of its cluster may be [m]")
        ->check(at_least_zero)
        ->capture_default_str();
  }

  void add_render() {
    CLI::App* command = add("render", "draw what a method knows after a frame, or as a film",
                            "ldm render ldm scenario3 --frame 200 -o map.png", [this] {
                              experiments::render(render_, folders());
                              return kGood;
                            });
    add_method_and_input(command, render_);
    allow_run(command);
    command->add_option("-o,--output", render_.output, "FILE.png, of one frame");
    command->add_option("--frame", render_.frame, "its number, from 0")->check(at_least_zero);
    command->add_option("--video", render_.video, "FILE.mp4, at the log's rate; needs ffmpeg");
    command->add_option("--from", render_.from, "first frame of the film")
        ->check(at_least_zero)
        ->capture_default_str();
    command->add_option("--to", render_.to, "last frame of the film (default: the last of all)")
        ->check(at_least_zero);
  }

  void add_view() {
    CLI::App* command = add("view", "show what a method knows, in a window while it runs",
                            "ldm view ldm scenario3", [this] {
                              experiments::view(view_, folders());
                              return kGood;
                            });
    add_method_and_input(command, view_);
    allow_run(command);
    command->add_option("--rate", view_.rate, "times the log's own speed")
        ->check(positive)
        ->capture_default_str();
    command->add_flag("--paused", view_.paused, "begin with a pause at the first frame");
  }

  /// Let the folder of a run stand for METHOD and INPUT.
  static void allow_run(CLI::App* command) {
    command->get_option("METHOD")->description(
        "a method that `ldm methods` lists; or, without INPUT, the output folder of `ldm run`, "
        "which is repeated");
    command->get_option("INPUT")->required(false);
  }

  static void add_method_and_input(CLI::App* command, experiments::MethodOnInput& request) {
    command->add_option("METHOD", request.method, "a method that `ldm methods` lists")->required();
    command
        ->add_option("INPUT", request.input,
                     "scenario (name or .toml file), or recording: .rawlog file of ours or MRPT's, "
                     "KITTI folder, folder of PCD files, bag of ROS (docs/recordings.md)")
        ->required();
    command->add_option("-c,--config", request.config,
                        "TOML file of parameters, or a preset: uav, road, indoor");
    repeatable(
        command->add_option("--set", request.settings,
                            "name=value of a parameter, or scenario.NAME=VALUE; may be repeated"));
    command->add_option("--seed", request.seed, "of a scenario's world (default 1)");
    add_recording_options(command, request);
  }

  static void add_recording_options(CLI::App* command, experiments::MethodOnInput& request) {
    command->add_option(
        "--format", request.format,
        "of a recording: kitti, pcd, bag, mrpt-rawlog, ldm-rawlog (default: recognised)");
    command->add_option("--poses", request.recording.poses,
                        "trajectory of a folder of scans, TUM's or KITTI's (default: its "
                        "poses.txt), or of a bag, TUM's");
    command->add_option("--points", request.recording.points, "topic of a bag with the scans");
    command->add_option("--poses-topic", request.recording.poses_topic,
                        "topic of a bag with the poses: TF, odometry or poses");
    command->add_option("--sensor-frame", request.recording.sensor_frame,
                        "frame that the scans of a bag are in, whatever they say");
    command->add_option("--times", request.recording.times,
                        "times of a folder of scans, one a line (default: its times.txt)");
    command->add_option("--time-unit", request.time_unit,
                        "of those two files: s, ms, us or ns (default: s)");
    command->add_flag("--keep-going", request.recording.keep_going,
                      "skip and count the frames of a log that are broken");
  }

  void add_fly() {
    CLI::App* command =
        add_list("fly",
                 "fly from start to goal by what a method maps; writes flight.csv, obstacles.csv, "
                 "plans.csv and summary.json",
                 "ldm fly ldm moving10_10 --seed 1 -o out", [this] {
                   fly_.command = datasets::command_line(words_);
                   experiments::fly(fly_, folders(), std::cout);
                 });
    command->add_option("ARM", fly_.arm, "a method, or blind, oracle, oracle_future")->required();
    command->add_option("WORLD", fly_.world, "name in datasets/corridors, or .toml file")
        ->required();
    command->add_option("--seed", fly_.seed, "of the world")->capture_default_str();
    repeatable(command->add_option("--set", fly_.settings,
                                   "name=value of flight, trust or map (docs/avoidance.md); may be "
                                   "repeated"));
    command->add_option("-o,--output", fly_.output, "folder, made if it is missing")->required();
    command->add_option("--video", fly_.video,
                        "FILE.mp4: map, clusters, UAV, planned and flown path; needs ffmpeg");
  }

  void add_trial() {
    CLI::App* command =
        add("trial", "run one trial of a study and write its record, or several",
            "ldm trial table1 scenario1.ldm.s001 -o record.json", [this] { return run_trials(); });
    add_study_options(command);
    command
        ->add_option("ID", trial_ids_,
                     "an id that `ldm trials STUDY` lists; of several, successive ones in the same "
                     "world share it")
        ->required();
    command
        ->add_option("-o,--output", records_,
                     "FILE.json; of several trials the folder of their ID.json")
        ->required();
    command->add_flag("--serial", trial_.serial,
                      "nothing else runs beside it: mark the times as such and keep all samples");
    command->add_option("--failed", trial_.failure,
                        "do not run it: write the record of a trial that ended so");
  }

  void add_study_options(CLI::App* command) {
    command->add_option("STUDY", trial_.study, "name or .toml file")->required();
    command->add_option("--seeds", trial_.options.seeds, "replicates, instead of the study's")
        ->check(CLI::Range(1, 100000));
    command->add_option("--frames", trial_.options.frames, "per trial, instead of the study's")
        ->check(CLI::Range(1, 1000000));
    repeatable(command->add_option("--method", trial_.options.methods,
                                   "instead of the study's methods; may be repeated"));
  }

  int run_trials() {
    trial_.data_dir = data_dir_;
    trial_.plugins = plugins_;
    int code = kGood;
    const auto note = [&](const std::string& id, const std::optional<std::string>& error) {
      if (error && !trial_.failure) {
        code = complain("trial " + id + " failed: " + *error, kFailed);
      }
    };
    const auto file_of = [&](const std::string& id) {
      return trial_ids_.size() == 1 ? records_ : records_ / (id + ".json");
    };
    if (experiments::is_flight_study(folders().studies.file(trial_.study))) {
      for (const std::string& id : trial_ids_) {
        trial_.id = id;
        note(id, experiments::run_flight_trial(trial_, file_of(id)));
      }
      return code;
    }
    experiments::run_trials(trial_, trial_ids_, [&](const experiments::TrialRecord& record) {
      experiments::write_record(record, file_of(record.id));
      note(record.id, record.error);
    });
    return code;
  }

  DataFolders folders() const { return DataFolders(data_dir_); }

  CLI::App app_{"Local dynamic maps for UAVs: the method, its baselines and their study.", "ldm"};
  std::vector<std::string> words_;
  std::function<int()> action_;
  std::optional<std::string> data_dir_;
  std::vector<std::string> plugins_;
  std::optional<std::string> of_;
  bool json_ = false;
  experiments::MethodOnInput info_;
  experiments::SimulateRequest simulate_;
  experiments::RunRequest run_;
  experiments::ScoreRequest score_;
  experiments::RenderRequest render_;
  experiments::ViewRequest view_;
  experiments::FlyRequest fly_;
  experiments::TrialRequest trial_;
  std::vector<std::string> trial_ids_;
  std::filesystem::path records_;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    return CommandLine({argv, argv + argc}).execute(argc, argv);
  } catch (const ldm::InvalidInput& error) {
    return complain(error.what(), kBadInput);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailed);
  }
}
