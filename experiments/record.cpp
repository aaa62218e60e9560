#include "experiments/record.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

namespace experiments {
namespace {

using Json = nlohmann::ordered_json;

/// A number or `true` where the text is one, else the text.
Json typed(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  std::int64_t whole = 0;
  double number = 0;
  const char* const end = text.data() + text.size();
  if (std::from_chars(text.data(), end, whole).ptr == end) return whole;
  if (std::from_chars(text.data(), end, number).ptr == end) return number;
  return text;
}

struct ParameterWriter {
  Json& json;

  template <class T>
  void operator()(const ldm::ParameterInfo& info, const T& value) const {
    json[std::string(info.name)] = value;
  }
  void operator()(const ldm::ParameterInfo& info, const Eigen::Vector3i& v) const {
    json[std::string(info.name)] = {v.x(), v.y(), v.z()};
  }
  template <class E, class Names>
  void operator()(const ldm::ParameterInfo& info, const E& value, const Names& names) const {
    json[std::string(info.name)] = names[static_cast<std::size_t>(value)];
  }
};

/// @param parameters any table that `visit_parameters` knows
template <class Table>
Json parameters_json(const Table& parameters) {
  Json json = Json::object();
  visit_parameters(parameters, ParameterWriter{json});
  return json;
}

Json counts_json(const datasets::InputCounts& counts) {
  return {{"frames_skipped", counts.frames_skipped},
          {"points_dropped", counts.points_dropped},
          {"other", counts.other}};
}

Json provenance_json(const Provenance& p, const std::optional<PluginFile>& plugin) {
  Json json = {{"version", p.version},       {"commit", p.commit},     {"dirty", p.dirty},
               {"binary", p.binary},         {"compiler", p.compiler}, {"flags", p.flags},
               {"build_type", p.build_type}, {"cpu", p.cpu},           {"cores", p.cores}};
  if (plugin) json["plugin"] = {{"file", plugin->name}, {"hash", plugin->hash}};
  return json;
}

Json scores_json(const Tallies& tallies) {
  Json json = Json::object();
  for (const Score& score : scores()) {
    const std::optional<double> value = score.value(tallies);
    json[std::string(score.name)] = value ? Json(*value) : Json(nullptr);
  }
  return json;
}

/// To 0.01 mm/s: a tenth of the digits, and far below what any estimate means.
Json rounded(const Eigen::Vector3d& v) {
  Json json = Json::array();
  for (const double x : v) json.push_back(std::round(x * 1e5) / 1e5);
  return json;
}

Json series_json(const std::vector<VelocitySeries>& all) {
  Json json = Json::array();
  for (const VelocitySeries& series : all) {
    Json truth = Json::array(), estimate = Json::array(), track = Json::array();
    for (const auto& v : series.true_velocity) truth.push_back(rounded(v));
    for (const auto& v : series.velocity) estimate.push_back(v ? rounded(*v) : Json(nullptr));
    for (const auto& id : series.track) track.push_back(id ? Json(*id) : Json(nullptr));
    json.push_back({{"object", series.object},
                    {"dynamic", series.dynamic},
                    {"frame", series.frame},
                    {"time_s", series.time},
                    {"true_velocity_mps", std::move(truth)},
                    {"velocity_mps", std::move(estimate)},
                    {"visible", series.visible},
                    {"track", std::move(track)}});
  }
  return json;
}

std::vector<double> after_warm_up(const std::vector<double>& samples) {
  const auto frames = static_cast<std::int64_t>(samples.size());
  return {samples.begin() + std::min(kWarmUpFrames, frames / 2), samples.end()};
}

/// @param serial nothing else ran: the raw samples are worth keeping
Json timing_json(const StageClock& clock, bool serial) {
  const std::vector<double> totals = after_warm_up(clock.totals());
  const TimeSummary total = summarize(totals);
  Json stages = Json::object();
  for (const StageClock::Stage& stage : clock.stages()) {
    const TimeSummary time = summarize(after_warm_up(stage.ms));
    stages[std::string(stage.name)] = {{"median", time.median}, {"mean", time.mean}};
  }
  Json json = {
      {"serial", serial},
      {"frames", totals.size()},
      {"update_time_ms",
       {{"median", total.median}, {"mean", total.mean}, {"p95", total.p95}, {"max", total.max}}},
      {"stages_ms", std::move(stages)}};
  if (serial) json["update_time_samples_ms"] = totals;
  return json;
}

/// What else it takes to run the method on the same frames again.
Json source_json(const MethodOnInput& request) {
  Json json = {{"folder", std::filesystem::current_path().string()}};
  if (!request.is_log()) json["seed"] = std::to_string(request.world_seed());
  if (request.format) json["format"] = *request.format;
  const datasets::RecordingOptions& recording = request.recording;
  if (recording.poses) json["poses"] = recording.poses->string();
  if (recording.times) json["times"] = recording.times->string();
  if (recording.keep_going) json["keep_going"] = true;
  return json;
}

/// One line for each key of the outermost object: readable, and short for the long arrays.
std::string dump(const Json& json) {
  std::string text = "{";
  for (const auto& [key, value] : json.items()) {
    text += (text.size() > 1 ? ",\n " : "\n ") + Json(key).dump() + ": " + value.dump();
  }
  return text + "\n}\n";
}

/// "name=value" of every parameter that `uses` keeps, as the command line takes it.
std::vector<std::string> settings_in(const Json& parameters,
                                     const std::function<bool(std::string_view)>& uses) {
  std::vector<std::string> settings;
  for (const auto& [name, value] : parameters.items()) {
    if (!uses(name)) continue;
    std::string text;
    if (value.is_array()) {
      for (const Json& element : value) text += (text.empty() ? "" : ",") + element.dump();
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
  if (source.contains("seed")) request.seed = std::stoull(source.at("seed").get<std::string>());
  const bool is_name = request.seed && !request.input.ends_with(".toml");
  if (!is_name) request.input = (folder / request.input).string();
  request.recording.poses = file("poses");
  request.recording.times = file("times");
  request.recording.keep_going = source.contains("keep_going");
  const Method& method = find_method(request.method);
  request.settings =
      settings_in(json.at("parameters"), [&](std::string_view name) { return uses(method, name); });
  if (json.contains("input_parameters")) {
    for (std::string& setting :
         settings_in(json.at("input_parameters"), [](std::string_view) { return true; })) {
      request.settings.push_back(std::move(setting));
    }
  }
  return request;
}

Json score_json(const ObjectScore& score) {
  const auto value = [](const Mean& mean) {
    return mean.value() ? Json(*mean.value()) : Json(nullptr);
  };
  return {{"objects", score.objects},
          {"frames", score.frames},
          {"matched", score.matched()},
          {"position_error_m", value(score.position_error)},
          {"velocity_error_mps", value(score.velocity_error)},
          {"tracks", score.tracks},
          {"switches", score.switches}};
}

}  // namespace

std::string to_json(const TrialRecord& record, const Provenance& provenance) {
  Json point = Json::object();
  for (const Setting& setting : record.point) point[setting.name] = typed(setting.value);

  Json json = {{"schema", 1}, {"status", record.error ? "failed" : "ok"}};
  if (record.error) json["error"] = *record.error;
  json["command"] = record.command;
  json["study"] = record.study;
  json["id"] = record.id;
  json["scenario"] = record.scenario;
  json["method"] = record.method;
  json["replicate"] = record.replicate;
  json["point"] = std::move(point);
  json["seeds"] = {{"scenario", std::to_string(record.scenario_seed)},
                   {"filter", std::to_string(record.filter_seed)}};
  json["frames"] = record.frames;
  json["parameters"] = parameters_json(record.parameters);
  json["scenario_file_hash"] = record.scenario_file_hash;
  json["provenance"] = provenance_json(provenance, record.plugin);
  if (record.error) return dump(json);
  json["scores"] = scores_json(record.evaluation.tallies.value());
  json["series"] = series_json(record.evaluation.series);
  json["timing"] = timing_json(record.evaluation.clock, record.serial);
  return dump(json);
}

std::string to_json(const RunSummary& summary, const Provenance& provenance) {
  Json json = {{"schema", 1},
               {"command", summary.command},
               {"method", summary.request.method},
               {"input", summary.request.input},
               {"source", source_json(summary.request)},
               {"frames", summary.evaluation.frames},
               {"interrupted", summary.interrupted},
               {"parameters", parameters_json(summary.parameters)},
               {"provenance", provenance_json(provenance, summary.plugin)}};
  if (summary.input_parameters) {
    json["input_parameters"] = parameters_json(*summary.input_parameters);
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
  try {
    return request_of(Json::parse(stream));
  } catch (const Json::exception& error) {
    throw ldm::InvalidInput(summary.string() + ": no summary of this version: " + error.what());
  }
}

std::string to_json(const TruthScore& score, const std::string& truth, double gate) {
  Json json = {{"schema", 1},
               {"truth", truth},
               {"gate_m", gate},
               {"frames", score.frames},
               {"frames_not_in_run", score.not_run},
               {"dynamic", score_json(score.of_dynamic)},
               {"static", score_json(score.of_static)},
               {"dynamic_clusters_without_object", score.dynamic_without_object},
               {"dynamic_clusters_on_static_objects", score.dynamic_on_static}};
  for (const auto& [id, object] : score.objects) {
    Json row = {{"id", id}, {"dynamic", object.dynamic}};
    row.update(score_json(object.score));
    row.erase("objects");
    json["objects"].push_back(std::move(row));
  }
  return dump(json);
}

}  // namespace experiments
