#include "experiments/study/trial_record.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "datasets/files/text.h"
#include "experiments/method/result_json.h"

namespace experiments {
namespace {

/// Of both files; raised when a reader of the old ones would go wrong.
constexpr int kSchema = 2;

/// A number or `true` where the text is one, else the text.
Json typed(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  std::int64_t whole = 0;
  double number = 0;
  if (datasets::parse_number(text, whole)) return whole;
  if (datasets::parse_number(text, number)) return number;
  return text;
}

/// To 0.01 mm/s: a tenth of the digits, and far below what any estimate means.
Json rounded(const Eigen::Vector3d& v) {
  Json json = Json::array();
  for (const double x : v) json.push_back(std::round(x * 1e5) / 1e5);
  return json;
}

Json objects_json(const std::vector<VelocitySeries>& all) {
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

}  // namespace

Json head_json(const RecordHead& head, Json point, Json parameters, const Provenance& provenance) {
  Json files = Json::object();
  for (const ReadFile& file : head.files) files[file.path] = file.hash;

  Json json = {{"schema", kSchema}, {"status", head.error ? "failed" : "ok"}};
  if (head.error) json["error"] = *head.error;
  json["command"] = head.command;
  json["study"] = head.study;
  json["id"] = head.id;
  json["scenario"] = head.scenario;
  json["method"] = head.method;
  json["replicate"] = head.replicate;
  json["point"] = std::move(point);
  json["seeds"] = {{"scenario", std::to_string(head.scenario_seed)},
                   {"filter", std::to_string(head.filter_seed)}};
  json["frames"] = head.frames;
  json["parameters"] = std::move(parameters);
  json["files"] = std::move(files);
  json["scenario_file_hash"] = head.scenario_file_hash;
  json["provenance"] = provenance_json(provenance, head.plugin);
  return json;
}

std::string to_json(const TrialRecord& record, const Provenance& provenance,
                    std::size_t series_bytes) {
  Json point = Json::object();
  for (const Setting& setting : record.point) point[setting.name] = typed(setting.value);
  Json json = head_json(record, std::move(point), parameters_json(record.parameters), provenance);
  if (record.error) return dump(json);
  json["scores"] = scores_json(record.evaluation.tallies.value());
  json["series_bytes"] = series_bytes;
  json["timing"] = timing_json(record.evaluation.clock, record.serial);
  return dump(json);
}

std::string series_json(const TrialRecord& record) {
  if (record.evaluation.series.empty()) return {};
  return dump({{"schema", kSchema},
               {"study", record.study},
               {"id", record.id},
               {"series", objects_json(record.evaluation.series)}});
}

}  // namespace experiments
