#include "ldm/plain/local_dynamic_map.h"

#include <algorithm>
#include <map>

#include "ldm/plain/log_odds.h"
#include "ldm/scan_check.h"

namespace ldm::plain {
namespace {

/// The grid after its window moved: voxels that stay keep their value, new ones get `empty`.
template <class Cell>
std::vector<Cell> moved(const std::vector<Cell>& grid, const VoxelBox& from, const VoxelBox& to,
                        Cell empty) {
  std::vector<Cell> result;
  for_each_voxel(to, [&](const VoxelIndex& v, std::size_t) {
    result.push_back(from.contains(v) ? grid[from.index(v)] : empty);
  });
  return result;
}

}  // namespace

LocalDynamicMap::LocalDynamicMap(const Parameters& parameters)
    : parameters_(checked(parameters)),
      window_{-parameters.map.voxels / 2, parameters.map.voxels},
      log_odds_(window_.count(), 0),
      labels_(window_.count(), kNoCluster),
      particles_(parameters) {
  const SubVoxelMotion motion = parameters.prediction.sub_voxel;
  if (motion != SubVoxelMotion::kResidual && motion != SubVoxelMotion::kNone) {
    throw InvalidInput(
        "prediction.sub_voxel = " + get_parameter(parameters, "prediction.sub_voxel") +
        ": allowed here: residual, none");
  }
}

void LocalDynamicMap::update(const Scan& scan, StageListener* listener) {
  check_scan(scan, time_);
  const auto begin = [&](std::string_view stage) {
    if (listener != nullptr) listener->begin(stage);
  };
  const double dt = scan.time - time_.value_or(scan.time);
  time_ = scan.time;

  begin("occupancy_prediction");
  predict_occupancy(dt);
  begin("particle_prediction");
  particles_.predict(dt);
  particles_.remove_outside(window_);
  begin("movement_update");
  update_movement(voxel_at(scan.T_world_uav.translation, parameters_.map.resolution));
  particles_.remove_outside(window_);
  begin("measurement_flags");
  const std::vector<VoxelFlag> flags =
      flag_voxels(scan, window_, parameters_.map.resolution,
                  parameters_.sensor_model.no_returns == NoReturnRays::kFree);
  begin("occupancy_update");
  update_occupancy(flags);
  begin("particle_update");
  if (particles_.empty()) particles_.scatter(window_);
  particles_.update(window_, log_odds_);
  begin("resampling");
  particles_.resample();
  begin("clustering");
  cluster();
  tracker_.follow(scan.time, clusters_);
}

// Sec. 3.2 ----------------------------------------------------------------------------------------

/// By how many whole voxels each cluster moves; what is left over is carried on.
std::vector<Eigen::Vector3i> LocalDynamicMap::plan_steps(double dt) {
  std::vector<Eigen::Vector3i> steps;
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    const Eigen::Vector3d v = clusters_[c].velocity.cast<double>();
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
    if (parameters_.prediction.sub_voxel == SubVoxelMotion::kResidual &&
        v.norm() >= parameters_.prediction.min_speed) {
      displacement = rests_[c] + v * dt / parameters_.map.resolution;
    }
    const Eigen::Vector3d whole = (displacement.array() + 0.5).floor();
    rests_[c] = displacement - whole;
    steps.push_back(whole.cast<int>());
  }
  return steps;
}

/// Fig. 3: the occupancy of each cluster moves with it.
void LocalDynamicMap::predict_occupancy(double dt) {
  const std::vector<Eigen::Vector3i> steps = plan_steps(dt);
  std::vector<double> predicted = log_odds_;
  predicted_labels_.assign(labels_.size(), kNoCluster);
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] != kNoCluster) predicted[i] = 0;
  }
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == kNoCluster) continue;
    const VoxelIndex to = window_.voxel(i) + steps[static_cast<std::size_t>(labels_[i])];
    if (!window_.contains(to)) continue;
    const std::size_t j = window_.index(to);
    predicted[j] = std::max(predicted[j], log_odds_[i]);
    predicted_labels_[j] = labels_[i];
  }
  log_odds_ = predicted;
}

// Sec. 3.3 ----------------------------------------------------------------------------------------

void LocalDynamicMap::update_movement(const VoxelIndex& uav) {
  const VoxelBox before = window_;
  window_.origin = uav - window_.size / 2;  // moves by X_k - X_{k-1}, as the UAV does.  Eq. (6)
  log_odds_ = moved(log_odds_, before, window_, 0.0);
  predicted_labels_ = moved(predicted_labels_, before, window_, kNoCluster);
}

void LocalDynamicMap::update_occupancy(const std::vector<VoxelFlag>& flags) {
  using Kind = VoxelFlag::Kind;
  const SensorModelParameters& sensor = parameters_.sensor_model;
  const SurvivalParameters& survival = parameters_.survival;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    double& l = log_odds_[i];
    if (flags[i].kind == Kind::kOccupied || flags[i].kind == Kind::kFree) {
      const double p = flags[i].kind == Kind::kOccupied ? sensor.p_occ : sensor.p_free;
      const double l_z = log_odds(p);  // l(z) = log(p / (1 - p)).  Eq. (9)
      // l_k = l_{k-1} + l(z), within the clamps.  Eq. (8)
      l = std::clamp(l + l_z, sensor.log_odds_min, sensor.log_odds_max);
    } else if (!survival.enabled || was_static(i)) {
      continue;
    } else {
      double p_s = survival.outside_view;
      if (flags[i].kind == Kind::kShadow) {
        p_s = survival.shadow * std::min(1.0, survival.shadow_range / flags[i].behind);
      }
      l *= p_s;  // l_k = l_{k-1} P_s.  Eq. (10)
    }
  }
}

bool LocalDynamicMap::was_static(std::size_t index) const {
  const int c = predicted_labels_[index];
  return c != kNoCluster && static_[static_cast<std::size_t>(c)];
}

bool LocalDynamicMap::is_occupied(std::size_t index) const {
  return probability(log_odds_[index]) > parameters_.clusters.occupied_above;
}

// Sec. 3.5 ----------------------------------------------------------------------------------------

void LocalDynamicMap::cluster() {
  labels_.assign(labels_.size(), kNoCluster);
  clusters_.clear();
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == kNoCluster && is_occupied(i)) collect_cluster(i);
  }
  inherit_rests();
  estimate_velocities();
}

/// Flood fill over the 26-neighbourhood.
void LocalDynamicMap::collect_cluster(std::size_t first_voxel) {
  const auto label = static_cast<int>(clusters_.size());
  VoxelIndex low = window_.voxel(first_voxel);
  VoxelIndex high = low;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::vector<std::size_t> members{first_voxel};
  labels_[first_voxel] = label;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const VoxelIndex voxel = window_.voxel(members[m]);
    low = low.cwiseMin(voxel);
    high = high.cwiseMax(voxel);
    sum += (voxel.cast<double>().array() + 0.5).matrix();
    const VoxelBox neighbours{voxel.array() - 1, Eigen::Vector3i::Constant(3)};
    for_each_voxel(neighbours, [&](const VoxelIndex& next, std::size_t) {
      if (!window_.contains(next)) return;
      const std::size_t i = window_.index(next);
      if (labels_[i] != kNoCluster || !is_occupied(i)) return;
      labels_[i] = label;
      members.push_back(i);
    });
  }
  const double resolution = parameters_.map.resolution;
  Cluster found;
  found.voxels = static_cast<std::int32_t>(members.size());
  found.position = (sum / found.voxels * resolution).cast<float>();
  found.size = ((high - low).cast<double>().array() + 1).matrix().cast<float>() *
               static_cast<float>(resolution);
  clusters_.push_back(found);
}

/// A cluster takes over the rest of the predicted cluster with which it shares most voxels.
void LocalDynamicMap::inherit_rests() {
  std::vector<std::map<int, int>> shared(clusters_.size());  // predicted cluster -> voxels
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == kNoCluster || predicted_labels_[i] == kNoCluster) continue;
    ++shared[static_cast<std::size_t>(labels_[i])][predicted_labels_[i]];
  }
  std::vector<Eigen::Vector3d> inherited(clusters_.size(), Eigen::Vector3d::Zero());
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    const auto most = std::max_element(shared[c].begin(), shared[c].end(),
                                       [](auto& a, auto& b) { return a.second < b.second; });
    if (most != shared[c].end()) inherited[c] = rests_[static_cast<std::size_t>(most->first)];
  }
  rests_ = inherited;
}

void LocalDynamicMap::estimate_velocities() {
  const std::vector<Eigen::Vector3d> velocities =
      particles_.cluster_velocities(window_, labels_, clusters_.size());
  static_.clear();
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    clusters_[c].velocity = velocities[c].cast<float>();
    clusters_[c].dynamic = velocities[c].norm() >= parameters_.clusters.static_below;
    static_.push_back(!clusters_[c].dynamic);
  }
  if (parameters_.clusters.readjust) particles_.readjust(window_, labels_, velocities);
}

void LocalDynamicMap::read(LocalMap& map) const {
  map.window = window_;
  map.resolution = parameters_.map.resolution;
  map.occupancy.clear();
  for (const double l : log_odds_) map.occupancy.push_back(static_cast<float>(probability(l)));
  map.labels.assign(labels_.begin(), labels_.end());
  map.clusters = clusters_;
}

}  // namespace ldm::plain
