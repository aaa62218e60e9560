#include "ldm/objects/object_ldm.h"

#include <algorithm>
#include <map>

#include "ldm/log_odds.h"
#include "ldm/read_occupancy.h"
#include "ldm/scan_check.h"

namespace ldm {
namespace {

constexpr double kAround = 1.5;  // beyond the map's border returns are followed so far [m]

}  // namespace

ObjectLdm::ObjectLdm(const Parameters& parameters, const Ingredients& ingredients)
    : parameters_(checked(parameters)),
      ingredients_(ingredients),
      log_odds_(parameters.map.voxels, 0.0F),
      flags_(parameters.map, parameters.sensor_model.no_returns, parameters.survival.enabled),
      prediction_(parameters.map, parameters.sensor_model, parameters.prediction),
      occupancy_(parameters.map, parameters.sensor_model, parameters.survival),
      clustering_(parameters.map, parameters.clusters),
      tracker_(parameters.map.resolution, ingredients),
      cluster_at_(log_odds_.index().count(), -1) {}

void ObjectLdm::update(const Scan& scan, StageListener* listener) {
  const auto stage = [listener](std::string_view name) {
    if (listener != nullptr) listener->begin(name);
  };
  check_scan(scan, time_);
  const double dt = scan.time - time_.value_or(scan.time);
  time_ = scan.time;

  stage("occupancy_prediction");  // Sec. 3.2
  prediction_.predict(dt, clustering_, log_odds_);

  stage("movement_update");  // Sec. 3.3
  log_odds_.recenter(voxel_at(scan.T_world_uav.translation, parameters_.map.resolution),
                     [this](std::size_t first, std::size_t n) { prediction_.forget(first, n); });
  stage("measurement_flags");
  flags_.mark(scan, log_odds_.index().window());
  stage("occupancy_update");
  occupancy_.apply(flags_.flags(), prediction_.kept(), log_odds_);

  stage("tracking");
  track(scan);
  if (ingredients_.one_return) occupy_seen();

  stage("clustering");  // Sec. 3.5
  clustering_.find(log_odds_);
  set_clusters();
  prediction_.inherit(log_odds_.index(), clustering_);
}

void ObjectLdm::track(const Scan& scan) {
  const double resolution = parameters_.map.resolution;
  const VoxelBox& window = log_odds_.index().window();
  const Eigen::Vector3d around = Eigen::Vector3d::Constant(ingredients_.margin ? kAround : 0);
  const Eigen::Array3d low = window.origin.cast<double>() * resolution - around;
  const Eigen::Array3d high = (window.origin + window.size).cast<double>() * resolution + around;
  points_.clear();
  for (const Point& p : scan.points) {
    const Eigen::Vector3d world = scan.T_world_sensor * p.cast<double>();
    if ((world.array() >= low).all() && (world.array() < high).all()) points_.push_back(world);
  }
  tracker_.update(scan.time, scan.T_world_sensor.translation, points_);
}

/// One return of what is followed is enough: the log-odds of a voxel that an object crosses in a
/// scan or two would have no time to rise.
void ObjectLdm::occupy_seen() {
  const auto hit = static_cast<float>(ldm::log_odds(parameters_.sensor_model.p_occ));
  for (const TrackedObject& object : tracker_.objects()) {
    if (object.seen() < *time_) continue;
    for (const Eigen::Vector3d& p : object.points()) {
      const VoxelIndex v = voxel_at(p, parameters_.map.resolution);
      if (log_odds_.index().window().contains(v)) log_odds_.at(v) = std::max(log_odds_.at(v), hit);
    }
  }
}

/// Per cluster the object that has most returns in it, as position in `objects`, or -1; where an
/// object is hidden, its last returns, moved on, count.
std::vector<std::int32_t> ObjectLdm::object_of_clusters() {
  const RingIndex& index = log_odds_.index();
  const std::size_t clusters = clustering_.clusters().size();
  std::fill(cluster_at_.begin(), cluster_at_.end(), -1);
  for (std::size_t c = 0; c < clusters; ++c) {
    for_each_slot(index, clustering_.runs_of(c),
                  [&](std::size_t slot) { cluster_at_[slot] = static_cast<std::int32_t>(c); });
  }
  std::vector<std::int64_t> most(clusters, 0);
  std::vector<std::int32_t> best(clusters, -1);
  const std::vector<TrackedObject>& objects = tracker_.objects();
  for (std::size_t t = 0; t < objects.size(); ++t) {
    std::map<std::int32_t, std::int64_t> returns;  // per cluster
    for (Eigen::Vector3d p : objects[t].points()) {
      p.head<2>() += objects[t].seen() < *time_ ? objects[t].since_view() : Eigen::Vector2d::Zero();
      const VoxelIndex v = voxel_at(p, parameters_.map.resolution);
      if (index.window().contains(v)) ++returns[cluster_at_[index.slot(v)]];
    }
    for (const auto& [c, n] : returns) {
      if (c < 0 || n <= most[static_cast<std::size_t>(c)]) continue;
      most[static_cast<std::size_t>(c)] = n;
      best[static_cast<std::size_t>(c)] = static_cast<std::int32_t>(t);
    }
  }
  return best;
}

/// What is seen in pieces is one cluster all the same.
void ObjectLdm::set_clusters() {
  std::vector<std::int32_t> owners = object_of_clusters();
  clustering_.join(owners, log_odds_.index().window());
  for (std::size_t c = 0; c < owners.size(); ++c) {
    if (owners[c] < 0) continue;
    const TrackedObject& object = tracker_.objects()[static_cast<std::size_t>(owners[c])];
    Cluster& cluster = clustering_.clusters()[c];
    cluster.id = object.id();
    cluster.age = *time_ - object.since();
    cluster.velocity << object.velocity().cast<float>(), 0;
    cluster.velocity_covariance = object.velocity_covariance().cast<float>();
    cluster.dynamic = object.dynamic();
  }
}

void ObjectLdm::read(LocalMap& map) const {
  read_occupancy(log_odds_, parameters_.map.resolution, map);
  clustering_.read(map);
}

}  // namespace ldm
