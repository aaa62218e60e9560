#include "experiments/runs/score_json.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/method/result_json.h"

namespace experiments {
namespace {

Json json_of(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json score_json(const ObjectScore& score) {
  return {{"objects", score.objects},
          {"frames", score.frames},
          {"matched", score.matched()},
          {"position_error_m", json_of(score.position_error.value())},
          {"velocity_error_mps", json_of(score.velocity_error.value())},
          {"tracks", score.tracks},
          {"switches", score.switches}};
}

Json object_json(const TruthScore& score) {
  Json json = {{"frames", score.frames},
               {"frames_not_in_run", score.not_run},
               {"dynamic", score_json(score.of_dynamic)},
               {"static", score_json(score.of_static)},
               {"moving_recall", json_of(score.recall.value())},
               {"moving_precision", json_of(score.precision.value())},
               {"dynamic_clusters_without_object", score.dynamic_without_object},
               {"dynamic_clusters_on_static_objects", score.dynamic_on_static}};
  for (const auto& [id, object] : score.objects) {
    Json row = {{"id", id}, {"dynamic", object.dynamic}};
    row.update(score_json(object.score));
    row.erase("objects");
    json["objects"].push_back(std::move(row));
  }
  return json;
}

Json count_json(const PointCounts& counts) {
  return {{"points", counts.points()},
          {"both_moving", counts.both_moving},
          {"run_only", counts.run_only},
          {"reference_only", counts.reference_only},
          {"moving_iou", json_of(counts.moving_iou())}};
}

}  // namespace

std::string to_json(const ScoreRequest& request, const RunScores& scores) {
  Json json = {{"schema", 2}};
  if (scores.objects) {
    json["truth"] = request.truth->string();
    json["gate_m"] = request.gate;
    json.update(object_json(*scores.objects));
  }
  if (scores.ghosts) {
    json["ghosts"] = {{"frames", scores.ghosts->frames},
                      {"ghost_voxels_per_frame", scores.ghosts->voxels_per_frame},
                      {"seconds_to_clear", json_of(scores.ghosts->seconds_to_clear)}};
  }
  if (scores.points) {
    json["labels"] = request.labels->string();
    json["points"] = {{"frames", scores.points->frames},
                      {"all", count_json(scores.points->all)},
                      {"in_map", count_json(scores.points->in_map)}};
  }
  return dump(json);
}

double summary_resolution(const std::filesystem::path& summary) {
  std::ifstream in(summary);
  const Json json = Json::parse(in, nullptr, false);
  const auto pointer = Json::json_pointer("/parameters/map.resolution_m");
  if (json.is_discarded() || !json.contains(pointer) || !json[pointer].is_number()) {
    throw ldm::InvalidInput(summary.string() + ": no summary of a run: allowed: that of `ldm run`");
  }
  return json[pointer].get<double>();
}

}  // namespace experiments
