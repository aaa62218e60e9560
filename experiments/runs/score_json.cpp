#include "experiments/runs/score_json.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/method/result_json.h"

namespace experiments {
namespace {

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

std::string to_json(const TruthScore& score, const std::optional<RunGhosts>& ghosts,
                    const std::string& truth, double gate) {
  Json json = {{"schema", 1},
               {"truth", truth},
               {"gate_m", gate},
               {"frames", score.frames},
               {"frames_not_in_run", score.not_run},
               {"dynamic", score_json(score.of_dynamic)},
               {"static", score_json(score.of_static)},
               {"dynamic_clusters_without_object", score.dynamic_without_object},
               {"dynamic_clusters_on_static_objects", score.dynamic_on_static}};
  if (ghosts) {
    const auto seconds = ghosts->seconds_to_clear;
    json["ghosts"] = {{"frames", ghosts->frames},
                      {"ghost_voxels_per_frame", ghosts->voxels_per_frame},
                      {"seconds_to_clear", seconds ? Json(*seconds) : Json(nullptr)}};
  }
  for (const auto& [id, object] : score.objects) {
    Json row = {{"id", id}, {"dynamic", object.dynamic}};
    row.update(score_json(object.score));
    row.erase("objects");
    json["objects"].push_back(std::move(row));
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
