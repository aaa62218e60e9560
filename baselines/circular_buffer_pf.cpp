#include "baselines/circular_buffer_pf.h"

#include "ldm/cluster_velocity.h"

namespace baselines {

CircularBufferPf::CircularBufferPf(const ldm::Parameters& parameters)
    : map_(parameters),
      cluster_parameters_(parameters.clusters),
      index_(map_.log_odds().index()),
      particles_(parameters.map, parameters.particles, parameters.clusters, parameters.execution,
                 index_),
      clustering_(parameters.map, parameters.clusters) {}

void CircularBufferPf::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  const auto stage = [listener](std::string_view name) {
    if (listener != nullptr) listener->begin(name);
  };
  map_.update(scan, listener);
  const double dt = scan.time - time_.value_or(scan.time);
  time_ = scan.time;

  stage("particle_prediction");
  particles_.predict(dt, index_);
  index_.recenter(map_.log_odds().index().centre(),
                  [this](std::size_t first, std::size_t n) { particles_.forget(first, n); });
  stage("particle_update");
  particles_.weigh(map_.log_odds());
  stage("resampling");
  particles_.resample(index_);
  stage("clustering");
  clustering_.find(map_.log_odds());
  ldm::set_cluster_velocities(cluster_parameters_, index_, particles_, clustering_);
  tracker_.follow(scan.time, clustering_.clusters());
}

void CircularBufferPf::read(ldm::LocalMap& map) const {
  map_.read(map);
  clustering_.read(map);
}

}  // namespace baselines
