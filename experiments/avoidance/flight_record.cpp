#include "experiments/avoidance/flight_record.h"

#include <nlohmann/json.hpp>

#include "experiments/method/plugins.h"
#include "experiments/method/result_json.h"

namespace experiments {
namespace {

Json settings_json(const FlightSettings& settings) {
  Json json = parameters_json(settings.map);
  visit_flight_settings(
      settings, [&](const char* name, double value, double, double) { json[name] = value; });
  return json;
}

Json time_json(const std::vector<double>& samples) {
  const TimeSummary time = summarize(samples);
  return {{"median", time.median}, {"mean", time.mean}, {"p95", time.p95}, {"max", time.max}};
}

/// Processor times; a plan is its distance field and its optimisation.
Json times_json(const FlightRecord& record) {
  const Flight& flight = record.flight;
  std::vector<double> plan_ms = flight.field_ms;
  for (std::size_t i = 0; i < plan_ms.size(); ++i) plan_ms[i] += flight.solve_ms[i];
  return {{"serial", record.serial},
          {"frames", flight.map_ms.size()},
          {"map_ms", time_json(flight.map_ms)},
          {"field_ms", time_json(flight.field_ms)},
          {"solve_ms", time_json(flight.solve_ms)},
          {"plan_ms", time_json(plan_ms)}};
}

}  // namespace

std::string to_json(const FlightRecord& record, const Provenance& provenance) {
  const Arm& arm = record.settings.arm;
  RecordHead head = record;
  head.scenario = record.world.name;
  head.method = arm.name;
  head.filter_seed = record.settings.map.execution.seed;
  head.frames = record.world.frames;
  head.scenario_file_hash = datasets::scenario_hash(record.world);
  if (arm.method != nullptr) head.plugin = plugin_of(*arm.method);
  Json point = Json::object();
  for (const Setting& setting : record.point) point[setting.name] = setting.value;
  Json json = head_json(head, std::move(point), settings_json(record.settings), provenance);
  if (record.error) return dump(json);
  json["outcome"] = kOutcomeNames[static_cast<std::size_t>(record.flight.outcome)];
  json["hit_obstacle"] = record.flight.hit ? Json(*record.flight.hit) : Json(nullptr);
  Json scores = Json::object();
  for (const auto& [name, value] : record.scores) {
    scores[std::string(name)] = value ? Json(*value) : Json(nullptr);
  }
  json["scores"] = std::move(scores);
  json["series_bytes"] = 0;
  json["timing"] = times_json(record);
  return dump(json);
}

}  // namespace experiments
