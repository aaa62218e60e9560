#include "experiments/method/methods.h"

#include <algorithm>
#include <set>
#include <string>

#include "baselines/centroid_kalman.h"
#include "baselines/circular_buffer.h"
#include "baselines/circular_buffer_pf.h"
#include "baselines/current_scan.h"
#include "baselines/empty_map.h"
#include "baselines/octomap.h"
#include "datasets/files/text.h"
#include "experiments/method/exact_positions.h"
#include "ldm/local_dynamic_map.h"
#include "ldm/objects/object_ldm.h"
#include "ldm/plain/local_dynamic_map.h"

namespace experiments {
namespace {

using ldm::create;

/// object_ldm that lacks one of its ingredients.
template <bool ldm::Ingredients::*left_out>
std::unique_ptr<ldm::Mapper> create_without(const ldm::Parameters& parameters) {
  ldm::Ingredients others;
  others.*left_out = false;
  return std::make_unique<ldm::ObjectLdm>(parameters, others);
}

/// Velocities to centimetres a second move occupancy by parts of a voxel; what stands stays put.
Method object_ldm(std::string_view name, std::string_view help,
                  std::unique_ptr<ldm::Mapper> (*create)(const ldm::Parameters&)) {
  return {
      .name = name,
      .help = help,
      .finds_clusters = true,
      .parameters = {"map", "sensor_model", "survival", "prediction", "clusters.occupied_above"},
      .overrides = {{"sensor_model.log_odds_max", "1.0"},
                    {"prediction.sub_voxel", "trilinear"},
                    {"prediction.min_speed_mps", "0.1"}},
      .create = create};
}

std::deque<Method>& table() {
  static std::deque<Method> rows = {
      {.name = "ldm",
       .help = "the paper's Local Dynamic Map",
       .finds_clusters = true,
       .parameters = {"map", "sensor_model", "survival", "prediction", "particles", "clusters",
                      "execution"},
       .create = create<ldm::LocalDynamicMap>},
      object_ldm("object_ldm",
                 "the map of ldm, moved by objects that are followed by their returns",
                 create<ldm::ObjectLdm>),
      {.name = "circular_buffer",
       .help = "hits and misses accumulated in a circular buffer ([11] of the paper)",
       .parameters = {"map", "sensor_model"},
       .create = create<baselines::CircularBuffer>},
      // A lower clamp alone forgets faster: a gain over [11] has to beat this, too.
      {.name = "circular_buffer_low_clamp",
       .help = "circular_buffer with the upper clamp of the log-odds at 1.0",
       .parameters = {"map", "sensor_model"},
       .overrides = {{"sensor_model.log_odds_max", "1.0"}},
       .create = create<baselines::CircularBuffer>},
      // Sigma and readjustment are the ones that served this method best. The two rows after it are
      // what the paper's "[11] with PF" may mean: the LDM's filter as it is, with or without
      // Eq. 17.
      {.name = "circular_buffer_pf",
       .help = "circular_buffer with the LDM's particle filter and clustering beside it, tuned",
       .finds_clusters = true,
       .parameters = {"map", "sensor_model", "particles", "clusters", "execution"},
       .overrides = {{"particles.sigma_xy_mps", "0.35"},
                     {"particles.sigma_z_mps", "0.35"},
                     {"particles.min_per_voxel", "20"},
                     {"clusters.readjust", "false"}},
       .create = create<baselines::CircularBufferPf>},
      {.name = "circular_buffer_pf_eq17",
       .help = "circular_buffer_pf with the LDM's own Sigma and with Eq. 17",
       .finds_clusters = true,
       .parameters = {"map", "sensor_model", "particles", "clusters", "execution"},
       .create = create<baselines::CircularBufferPf>},
      {.name = "circular_buffer_pf_free",
       .help = "circular_buffer_pf with the LDM's own Sigma and without Eq. 17",
       .finds_clusters = true,
       .parameters = {"map", "sensor_model", "particles", "clusters", "execution"},
       .overrides = {{"clusters.readjust", "false"}},
       .create = create<baselines::CircularBufferPf>},
      {.name = "octomap",
       .help = "OctoMap's global tree, read in the window of the local map ([9] of the paper)",
       .parameters = {"map", "sensor_model"},
       .create = create<baselines::Octomap>},
      {.name = "current_scan",
       .help = "only the voxels hit by the current scan are occupied: no memory",
       .parameters = {"map", "sensor_model"},
       .create = create<baselines::CurrentScan>},
      {.name = "centroid_kalman",
       .help = "current_scan with Euclidean clusters, each followed by one Kalman filter",
       .finds_clusters = true,
       .parameters = {"map", "sensor_model", "clusters.static_below_mps"},
       .create = create<baselines::CentroidKalman>},
      {.name = "exact_positions",
       .help = "current_scan with the filter of object_ldm, told where objects are: an oracle",
       .finds_clusters = true,
       .parameters = {"map", "sensor_model", "clusters.static_below_mps"},
       .create = create<ExactPositions>},
      {.name = "empty_map",
       .help = "knows nothing: every voxel is unknown; shows which scores silence wins",
       .parameters = {"map"},
       .create = create<baselines::EmptyMap>},
      // To read and to hold `ldm` to: too slow for a study.
      {.name = "plain_ldm",
       .help = "the same method as ldm in floating point, as the paper writes it: 50 times slower",
       .finds_clusters = true,
       .parameters = {"map", "sensor_model", "survival", "prediction", "particles", "clusters",
                      "execution.seed"},
       .create = create<ldm::plain::LocalDynamicMap>},
      // What each ingredient brings: the study `objects`.
      object_ldm("object_ldm_without_margin", "object_ldm, blind beyond the map's border",
                 create_without<&ldm::Ingredients::margin>),
      object_ldm("object_ldm_without_outline", "object_ldm that follows centres alone",
                 create_without<&ldm::Ingredients::outline>),
      object_ldm("object_ldm_without_slices", "object_ldm whose columns reach from bottom to top",
                 create_without<&ldm::Ingredients::slices>),
      object_ldm("object_ldm_without_edges", "object_ldm that knows no edges of objects",
                 create_without<&ldm::Ingredients::edges>),
      object_ldm("object_ldm_without_centre", "object_ldm that follows outlines alone",
                 create_without<&ldm::Ingredients::centre>),
      object_ldm("object_ldm_without_manoeuvres", "object_ldm with one Kalman filter an object",
                 create_without<&ldm::Ingredients::manoeuvres>),
      object_ldm("object_ldm_without_shift", "object_ldm that believes the pose of each scan",
                 create_without<&ldm::Ingredients::shift>),
      object_ldm("object_ldm_without_one_return", "object_ldm that occupies voxels as ldm does",
                 create_without<&ldm::Ingredients::one_return>),
  };
  return rows;
}

}  // namespace

const std::deque<Method>& methods() {
  return table();
}

void add_methods(const std::vector<Method>& rows) {
  std::set<std::string_view> names;
  for (const Method& method : methods()) names.insert(method.name);
  for (const Method& row : rows) {
    if (!names.insert(row.name).second) {
      throw ldm::InvalidInput("method " + std::string(row.name) +
                              " exists already: allowed: other names than " +
                              datasets::joined(names));
    }
  }
  table().insert(table().end(), rows.begin(), rows.end());
}

const Method& find_method(std::string_view name) {
  std::vector<std::string> known;
  for (const Method& method : methods()) {
    if (method.name == name) return method;
    known.emplace_back(method.name);
  }
  throw ldm::InvalidInput("unknown method " + std::string(name) + ": allowed: " +
                          datasets::joined(known) + datasets::did_you_mean(name, known));
}

ldm::Parameters default_parameters(const Method& method) {
  ldm::Parameters parameters;
  for (const auto& [name, value] : method.overrides) {
    ldm::set_parameter(parameters, name, value);
  }
  return parameters;
}

bool uses(const Method& method, std::string_view parameter) {
  return std::any_of(
      method.parameters.begin(), method.parameters.end(), [&](std::string_view used) {
        return parameter == used ||
               (parameter.starts_with(used) && parameter.substr(used.size()).starts_with('.'));
      });
}

void apply(const Setting& setting, const Method& method, ldm::Parameters& parameters) {
  apply(setting, parameters);
  if (uses(method, setting.name)) return;
  refuse(setting, "parameters that " + std::string(method.name) +
                      " uses: " + datasets::joined(method.parameters));
}

}  // namespace experiments
