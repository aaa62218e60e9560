#include "experiments/runs/score_json.h"

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
