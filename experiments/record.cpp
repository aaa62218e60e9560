#include "experiments/record.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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

Json parameters_json(const ldm::Parameters& parameters) {
  Json json = Json::object();
  ldm::visit_parameters(parameters, ParameterWriter{json});
  return json;
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
    Json truth = Json::array(), estimate = Json::array();
    for (const auto& v : series.true_velocity) truth.push_back(rounded(v));
    for (const auto& v : series.velocity) estimate.push_back(v ? rounded(*v) : Json(nullptr));
    json.push_back({{"object", series.object},
                    {"dynamic", series.dynamic},
                    {"frame", series.frame},
                    {"time_s", series.time},
                    {"true_velocity_mps", std::move(truth)},
                    {"velocity_mps", std::move(estimate)}});
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

/// One line for each key of the outermost object: readable, and short for the long arrays.
std::string dump(const Json& json) {
  std::string text = "{";
  for (const auto& [key, value] : json.items()) {
    text += (text.size() > 1 ? ",\n " : "\n ") + Json(key).dump() + ": " + value.dump();
  }
  return text + "\n}\n";
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
               {"method", summary.method},
               {"input", summary.input},
               {"frames", summary.evaluation.frames},
               {"parameters", parameters_json(summary.parameters)},
               {"provenance", provenance_json(provenance, summary.plugin)}};
  if (summary.evaluation.tallies) json["scores"] = scores_json(*summary.evaluation.tallies);
  json["timing"] = timing_json(summary.evaluation.clock, false);
  return dump(json);
}

}  // namespace experiments
