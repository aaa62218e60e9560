#include "ldm/local_dynamic_map.h"

#include "ldm/read_occupancy.h"
#include "ldm/scan_check.h"

namespace ldm {
namespace {

/// With the number of threads that 0 stands for.
Parameters with_threads(Parameters parameters) {
  std::int64_t& threads = parameters.execution.threads;
  if (threads == 0) threads = threads_that_pay(parameters);
  return parameters;
}

}  // namespace

LocalDynamicMap::LocalDynamicMap(const Parameters& parameters)
    : parameters_(with_threads(checked(parameters))),
      log_odds_(parameters.map.voxels, 0.0F),
      flags_(parameters.map, parameters.sensor_model.no_returns, parameters.survival.enabled,
             parameters_.execution.threads),
      prediction_(parameters.map, parameters.sensor_model, parameters.prediction),
      occupancy_(parameters.map, parameters.sensor_model, parameters.survival,
                 parameters_.execution.threads),
      particles_(parameters.map, parameters.particles, parameters.clusters, parameters_.execution,
                 log_odds_.index()),
      clustering_(parameters.map, parameters.clusters) {}

void LocalDynamicMap::update(const Scan& scan, StageListener* listener) {
  const auto stage = [listener](std::string_view name) {
    if (listener != nullptr) listener->begin(name);
  };
  check_scan(scan, time_);
  const double dt = scan.time - time_.value_or(scan.time);
  time_ = scan.time;

  stage("occupancy_prediction");  // Sec. 3.2
  prediction_.predict(dt, clustering_, log_odds_);
  stage("particle_prediction");
  particles_.predict(dt, log_odds_.index());

  stage("movement_update");  // Sec. 3.3
  movement_update(scan);
  stage("measurement_flags");
  flags_.mark(scan, log_odds_.index().window());
  stage("occupancy_update");
  occupancy_.apply(flags_.flags(), prediction_.kept(), log_odds_);
  stage("particle_update");
  particles_.weigh(log_odds_);

  stage("resampling");  // Sec. 3.4
  particles_.resample(log_odds_.index());

  stage("clustering");  // Sec. 3.5
  clustering_.find(log_odds_);
  set_cluster_velocities(parameters_.clusters, log_odds_.index(), particles_, clustering_);
  prediction_.inherit(log_odds_.index(), clustering_);
  tracker_.follow(scan.time, clustering_.clusters());
}

/// The map follows the UAV by whole voxels; what leaves it is forgotten.
void LocalDynamicMap::movement_update(const Scan& scan) {
  const VoxelIndex centre = voxel_at(scan.T_world_uav.translation, parameters_.map.resolution);
  log_odds_.recenter(centre, [this](std::size_t first, std::size_t n) {
    prediction_.forget(first, n);
    particles_.forget(first, n);
  });
}

void LocalDynamicMap::read(LocalMap& map) const {
  read_occupancy(log_odds_, parameters_.map.resolution, map);
  clustering_.read(map);
}

}  // namespace ldm
