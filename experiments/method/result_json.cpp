#include "experiments/method/result_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace experiments {
namespace {

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
Json table_json(const Table& parameters) {
  Json json = Json::object();
  visit_parameters(parameters, ParameterWriter{json});
  return json;
}

std::vector<double> after_warm_up(const std::vector<double>& samples) {
  const auto frames = static_cast<std::int64_t>(samples.size());
  return {samples.begin() + std::min(kWarmUpFrames, frames / 2), samples.end()};
}

}  // namespace

Json parameters_json(const ldm::Parameters& parameters) {
  return table_json(parameters);
}

Json parameters_json(const datasets::InputParameters& parameters) {
  return table_json(parameters);
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

std::string dump(const Json& json) {
  // A name of a file may be in Latin-1, which no JSON holds: `?` in its place.
  const auto line = [](const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string text = "{";
  for (const auto& [key, value] : json.items()) {
    text += (text.size() > 1 ? ",\n " : "\n ") + line(key) + ": " + line(value);
  }
  return text + "\n}\n";
}

}  // namespace experiments
