#include "experiments/method/method_on_input.h"

#include <algorithm>

#include "datasets/files/text.h"
#include "datasets/recording/recording.h"
#include "datasets/scenario/simulation.h"

namespace experiments {
namespace {

namespace fs = std::filesystem;

struct GivenSettings {
  Settings file;
  bool file_is_preset = false;
  Settings options;  ///< of the command line
};

GivenSettings given_settings(const MethodOnInput& request, const DataFolders& folders) {
  GivenSettings given;
  if (request.config) {
    const std::string& name = *request.config;
    given.file_is_preset = !name.ends_with(".toml") && !fs::is_regular_file(name);
    given.file = read_settings(given.file_is_preset ? folders.presets.file(name) : fs::path(name));
  }
  for (const std::string& argument : request.settings) {
    given.options.push_back(parse_setting(argument));
  }
  return given;
}

/// The value that a word of the command line names.
template <class Choice, std::size_t n>
Choice choice_of(const std::string& option, const std::string& word,
                 const std::string_view (&names)[n]) {
  const auto* const name = std::find(std::begin(names), std::end(names), word);
  if (name == std::end(names)) {
    throw ldm::InvalidInput(
        option + " " + word + ": allowed: " + datasets::joined(names) +
        datasets::did_you_mean(word, std::vector<std::string>(std::begin(names), std::end(names))));
  }
  return static_cast<Choice>(name - names);
}

std::optional<datasets::RecordingFormat> format_of(const MethodOnInput& request) {
  if (!request.format) return datasets::recognised_format(request.input);
  return choice_of<datasets::RecordingFormat>("--format", *request.format,
                                              datasets::kRecordingFormatNames);
}

/// True for what is read with input.* parameters.
bool is_recording(const MethodOnInput& request) {
  return request.is_log() && format_of(request) != datasets::RecordingFormat::kLdmRawlog;
}

/// A name is a scenario's or that of what lies there; a misspelt one is none of both.
void check_input(const MethodOnInput& request, const DataFolders& folders) {
  if (request.is_log() || request.input.ends_with(".toml")) return;
  const std::vector<std::string> names = folders.scenarios.names();
  if (std::find(names.begin(), names.end(), request.input) != names.end()) return;
  if (fs::exists(request.input)) datasets::open_recording(request.input, request.recording);
  throw ldm::InvalidInput(request.input +
                          ": no such recording or scenario: allowed: a file or folder that is "
                          "there, a .toml file, " +
                          datasets::joined(names) + datasets::did_you_mean(request.input, names));
}

bool is_of_method(const Setting& setting) {
  return !datasets::is_input_parameter(setting.name) && scenario_key(setting).empty();
}

[[noreturn]] void refuse_option(const std::string& option, std::string_view allowed) {
  throw ldm::InvalidInput(option + ": allowed: " + std::string(allowed));
}

void refuse_recording_options(const MethodOnInput& request) {
  constexpr std::string_view kWithRecording = "with a recording (KITTI, PCD, MRPT, bags)";
  const std::pair<const char*, std::optional<std::string>> of_bags[] = {
      {"--points ", request.recording.points},
      {"--poses-topic ", request.recording.poses_topic},
      {"--sensor-frame ", request.recording.sensor_frame}};
  for (const auto& [option, value] : of_bags) {
    if (value) refuse_option(option + *value, "with a bag");
  }
  const datasets::RecordingOptions& options = request.recording;
  if (request.time_unit) refuse_option("--time-unit " + *request.time_unit, kWithRecording);
  if (options.poses) refuse_option("--poses " + options.poses->string(), kWithRecording);
  if (options.times) refuse_option("--times " + options.times->string(), kWithRecording);
}

}  // namespace

bool MethodOnInput::is_log() const {
  if (format || input.ends_with(".rawlog")) return true;
  if (input.ends_with(".toml")) return false;
  return input.find('/') != std::string::npos || datasets::recognised_format(input).has_value();
}

ldm::Parameters parameters_of(const MethodOnInput& request, const Method& method,
                              const DataFolders& folders) {
  ldm::Parameters parameters = default_parameters(method);
  parameters.execution.threads = 0;
  const GivenSettings given = given_settings(request, folders);
  for (const Setting& setting : given.file) {
    if (!is_of_method(setting)) continue;
    if (given.file_is_preset && !uses(method, setting.name)) continue;
    apply(setting, method, parameters);
  }
  for (const Setting& setting : given.options) {
    if (is_of_method(setting)) apply(setting, method, parameters);
  }
  std::int64_t& threads = parameters.execution.threads;
  if (threads == 0) threads = ldm::threads_that_pay(parameters);
  return parameters;
}

std::optional<datasets::InputParameters> input_parameters_of(const MethodOnInput& request,
                                                             const DataFolders& folders) {
  check_input(request, folders);
  const bool recording = is_recording(request);
  datasets::InputParameters parameters;
  const GivenSettings given = given_settings(request, folders);
  for (const Settings* settings : {&given.file, &given.options}) {
    for (const Setting& setting : *settings) {
      if (!datasets::is_input_parameter(setting.name)) continue;
      if (!recording) {
        refuse(setting,
               "with a recording (KITTI, PCD, MRPT, bags); scenarios and logs of `ldm simulate` "
               "are taken as they are");
      }
      apply(setting, parameters);
    }
  }
  if (!recording) return {};
  datasets::check(parameters);
  return parameters;
}

Settings scenario_settings_of(const MethodOnInput& request, const DataFolders& folders) {
  const GivenSettings given = given_settings(request, folders);
  Settings found;
  for (const Settings* settings : {&given.file, &given.options}) {
    for (const Setting& setting : *settings) {
      if (!scenario_key(setting).empty()) found.push_back(setting);
    }
  }
  return found;
}

datasets::RecordingOptions recording_options_of(const MethodOnInput& request,
                                                const DataFolders& folders) {
  datasets::RecordingOptions options = request.recording;
  options.format = format_of(request);
  if (request.time_unit) {
    options.time_unit =
        choice_of<datasets::TimeUnit>("--time-unit", *request.time_unit, datasets::kTimeUnitNames);
  }
  if (const auto input = input_parameters_of(request, folders)) options.input = *input;
  return options;
}

std::unique_ptr<datasets::FrameSource> open_input(const MethodOnInput& request,
                                                  const DataFolders& folders,
                                                  std::optional<std::int64_t> frames) {
  const std::optional<datasets::InputParameters> input = input_parameters_of(request, folders);
  if (!input) refuse_recording_options(request);
  if (!request.is_log()) {
    if (request.recording.keep_going) refuse_option("--keep-going", "with a log or a recording");
    datasets::Scenario scenario = datasets::read_scenario(folders.scenarios.file(request.input));
    for (const Setting& setting : scenario_settings_of(request, folders)) apply(setting, scenario);
    return std::make_unique<datasets::Simulation>(scenario, request.world_seed(), frames);
  }
  for (const Setting& setting : scenario_settings_of(request, folders)) {
    refuse(setting, "with a scenario; a log is taken as it is");
  }
  if (request.seed) {
    throw ldm::InvalidInput("--seed " + std::to_string(*request.seed) +
                            ": allowed: with a scenario; a log has no seed");
  }
  datasets::RecordingOptions options = recording_options_of(request, folders);
  options.origin_step = parameters_of(request, find_method(request.method), folders).map.resolution;
  return datasets::open_recording(request.input, options);
}

}  // namespace experiments
