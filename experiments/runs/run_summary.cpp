#include "experiments/runs/run_summary.h"

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "datasets/files/at_place.h"
#include "datasets/files/text.h"
#include "experiments/method/result_json.h"

namespace experiments {
namespace {

Json counts_json(const datasets::InputCounts& counts) {
  return {{"frames_skipped", counts.frames_skipped},
          {"points_dropped", counts.points_dropped},
          {"other", counts.other},
          {"other_sensors", counts.other_sensors}};
}

/// What else it takes to run the method on the same frames again.
Json source_json(const RunSummary& summary) {
  const MethodOnInput& request = summary.request;
  Json json = {{"folder", std::filesystem::current_path().string()}};
  if (!request.is_log()) json["seed"] = std::to_string(request.world_seed());
  for (const Setting& setting : summary.scenario_settings) {
    json["set"].push_back(setting.name + '=' + setting.value);
  }
  if (request.format) json["format"] = *request.format;
  const datasets::RecordingOptions& recording = request.recording;
  if (recording.poses) json["poses"] = recording.poses->string();
  if (recording.times) json["times"] = recording.times->string();
  if (recording.points) json["points"] = *recording.points;
  if (recording.poses_topic) json["poses_topic"] = *recording.poses_topic;
  if (recording.sensor_frame) json["sensor_frame"] = *recording.sensor_frame;
  if (request.time_unit) json["time_unit"] = *request.time_unit;
  if (recording.keep_going) json["keep_going"] = true;
  return json;
}

/// "name=value" of every parameter that `uses` keeps, as the command line takes it.
std::vector<std::string> settings_in(const Json& parameters,
                                     const std::function<bool(std::string_view)>& uses) {
  std::vector<std::string> settings;
  for (const auto& [name, value] : parameters.items()) {
    if (!uses(name)) continue;
    std::string text;
    if (value.is_array()) {
      for (const Json& element : value) {
        if (!text.empty()) text += ',';
        text += element.dump();
      }
    } else {
      text = value.is_string() ? value.get<std::string>() : value.dump();
    }
    settings.push_back(name + "=" + text);
  }
  return settings;
}

MethodOnInput request_of(const Json& json) {
  MethodOnInput request;
  request.method = json.at("method").get<std::string>();
  const Json& source = json.at("source");
  const std::filesystem::path folder = source.at("folder").get<std::string>();
  const auto file = [&](const char* key) -> std::optional<std::filesystem::path> {
    if (!source.contains(key)) return {};
    return folder / source.at(key).get<std::string>();
  };
  request.input = json.at("input").get<std::string>();
  if (source.contains("format")) request.format = source.at("format").get<std::string>();
  const auto text = [&](const char* key) -> std::optional<std::string> {
    if (!source.contains(key)) return {};
    return source.at(key).get<std::string>();
  };
  request.recording.points = text("points");
  request.recording.poses_topic = text("poses_topic");
  request.recording.sensor_frame = text("sensor_frame");
  request.time_unit = text("time_unit");
  if (const std::optional<std::string> seed = text("seed");
      seed && !datasets::parse_number(*seed, request.seed.emplace())) {
    throw ldm::InvalidInput("source.seed = " + *seed + ": allowed: a whole number from 0 on");
  }
  const bool is_name = request.seed && !request.input.ends_with(".toml");
  if (!is_name) request.input = (folder / request.input).string();
  request.recording.poses = file("poses");
  request.recording.times = file("times");
  request.recording.keep_going = source.contains("keep_going");
  const Method& method = find_method(request.method);
  request.settings =
      settings_in(json.at("parameters"), [&](std::string_view name) { return uses(method, name); });
  for (const Json& setting : source.value("set", Json::array())) {
    request.settings.push_back(setting.get<std::string>());
  }
  if (json.contains("input_parameters")) {
    for (std::string& setting :
         settings_in(json.at("input_parameters"), [](std::string_view) { return true; })) {
      request.settings.push_back(std::move(setting));
    }
  }
  return request;
}

}  // namespace

std::string to_json(const RunSummary& summary, const Provenance& provenance) {
  Json json = {{"schema", 1},
               {"command", summary.command},
               {"method", summary.request.method},
               {"input", summary.request.input},
               {"source", source_json(summary)},
               {"frames", summary.evaluation.frames},
               {"interrupted", summary.interrupted},
               {"parameters", parameters_json(summary.parameters)},
               {"provenance", provenance_json(provenance, summary.plugin)}};
  if (summary.input_parameters) {
    json["input_parameters"] = parameters_json(*summary.input_parameters);
  }
  if (!summary.origin.isZero()) {
    json["origin_m"] = {summary.origin.x(), summary.origin.y(), summary.origin.z()};
  }
  if (summary.input_parameters || summary.input_counts.skipped() > 0) {
    json["input_counts"] = counts_json(summary.input_counts);
  }
  if (summary.real_time) {
    const RealTime& played = *summary.real_time;
    json["real_time"] = {{"rate", played.rate},
                         {"late_frames", played.late.frames},
                         {"worst_lateness_s", played.late.worst}};
  }
  if (summary.evaluation.tallies) json["scores"] = scores_json(*summary.evaluation.tallies);
  json["timing"] = timing_json(summary.evaluation.clock, false);
  return dump(json);
}

MethodOnInput read_request(const std::filesystem::path& summary) {
  std::ifstream stream(summary);
  if (!stream) {
    throw ldm::InvalidInput(summary.string() +
                            ": cannot be read: allowed: summary.json in a folder of `ldm run`");
  }
  MethodOnInput request;
  datasets::at_place(summary.string(), [&] {
    try {
      request = request_of(Json::parse(stream));
    } catch (const Json::exception& error) {
      throw ldm::InvalidInput(std::string("no summary of this version: ") + error.what());
    }
  });
  return request;
}

}  // namespace experiments
