#include "tests/reference/plain_ldm.h"

#include <algorithm>
#include <map>

#include "ldm/scan_check.h"
#include "tests/reference/plain_log_odds.h"
#include "tests/reference/voxel_boxes.h"

namespace reference {
namespace {

/// The grid after its window moved: voxels that stay keep their value, new ones get `empty`.
template <class Cell>
std::vector<Cell> moved(const std::vector<Cell>& grid, const ldm::VoxelBox& from,
                        const ldm::VoxelBox& to, Cell empty) {
  std::vector<Cell> result;
  for_each_voxel(to, [&](const ldm::VoxelIndex& v) {
    result.push_back(from.contains(v) ? grid[from.index(v)] : empty);
  });
  return result;
}

}  // namespace

PlainLdm::PlainLdm(const ldm::Parameters& parameters)
    : parameters_(ldm::checked(parameters)),
      window_{-parameters.map.voxels / 2, parameters.map.voxels},
      log_odds_(window_.count(), 0),
      labels_(window_.count(), kNobody),
      particles_(parameters) {
  const ldm::SubVoxelMotion motion = parameters.prediction.sub_voxel;
  if (motion != ldm::SubVoxelMotion::kResidual && motion != ldm::SubVoxelMotion::kNone) {
    throw ldm::InvalidInput(
        "prediction.sub_voxel = " + ldm::get_parameter(parameters, "prediction.sub_voxel") +
        ": allowed here: residual, none");
  }
}

void PlainLdm::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  ldm::check_scan(scan, time_);
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
  update_movement(ldm::voxel_at(scan.T_world_uav.translation, parameters_.map.resolution));
  particles_.remove_outside(window_);
  begin("measurement_flags");
  const std::vector<VoxelFlag> flags =
      flag_voxels(scan, window_, parameters_.map.resolution,
                  parameters_.sensor_model.no_returns == ldm::NoReturnRays::kFree);
  begin("occupancy_update");
  update_occupancy(flags);
  begin("particle_update");
  if (particles_.empty()) particles_.scatter(window_);
  particles_.update(window_, log_odds_);
  begin("resampling");
  particles_.resample();
  begin("clustering");
  cluster();
}

// Sec. 3.2 ----------------------------------------------------------------------------------------

/// By how many whole voxels each cluster moves; what is left over is carried on.
std::vector<Eigen::Vector3i> PlainLdm::plan_steps(double dt) {
  std::vector<Eigen::Vector3i> steps;
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    const Eigen::Vector3d v = clusters_[c].velocity.cast<double>();
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
    if (parameters_.prediction.sub_voxel == ldm::SubVoxelMotion::kResidual &&
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
void PlainLdm::predict_occupancy(double dt) {
  const std::vector<Eigen::Vector3i> steps = plan_steps(dt);
  std::vector<double> predicted = log_odds_;
  predicted_labels_.assign(labels_.size(), kNobody);
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] != kNobody) predicted[i] = 0;
  }
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == kNobody) continue;
    const ldm::VoxelIndex to = voxel_of(window_, i) + steps[static_cast<std::size_t>(labels_[i])];
    if (!window_.contains(to)) continue;
    const std::size_t j = window_.index(to);
    predicted[j] = std::max(predicted[j], log_odds_[i]);
    predicted_labels_[j] = labels_[i];
  }
  log_odds_ = predicted;
}

// Sec. 3.3 ----------------------------------------------------------------------------------------

void PlainLdm::update_movement(const ldm::VoxelIndex& uav) {
  const ldm::VoxelBox before = window_;
  window_.origin = uav - window_.size / 2;
  log_odds_ = moved(log_odds_, before, window_, 0.0);
  predicted_labels_ = moved(predicted_labels_, before, window_, kNobody);
}

/// See eq. 8 to 10.
void PlainLdm::update_occupancy(const std::vector<VoxelFlag>& flags) {
  using Kind = VoxelFlag::Kind;
  const ldm::SensorModelParameters& sensor = parameters_.sensor_model;
  const ldm::SurvivalParameters& survival = parameters_.survival;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    double& l = log_odds_[i];
    if (flags[i].kind == Kind::kOccupied || flags[i].kind == Kind::kFree) {
      const double p = flags[i].kind == Kind::kOccupied ? sensor.p_occ : sensor.p_free;
      l = std::clamp(l + to_log_odds(p), sensor.log_odds_min, sensor.log_odds_max);
    } else if (!survival.enabled || was_static(i)) {
      continue;
    } else if (flags[i].kind == Kind::kShadow) {
      l *= survival.shadow * std::min(1.0, survival.shadow_range / flags[i].behind);
    } else {
      l *= survival.outside_view;
    }
  }
}

bool PlainLdm::was_static(std::size_t index) const {
  const int c = predicted_labels_[index];
  return c != kNobody && !clusters_[static_cast<std::size_t>(c)].dynamic;
}

bool PlainLdm::is_occupied(std::size_t index) const {
  return to_probability(log_odds_[index]) > parameters_.clusters.occupied_above;
}

// Sec. 3.5 ----------------------------------------------------------------------------------------

void PlainLdm::cluster() {
  labels_.assign(labels_.size(), kNobody);
  clusters_.clear();
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == kNobody && is_occupied(i)) collect_cluster(i);
  }
  inherit_rests();
  estimate_velocities();
}

/// Flood fill over the 26-neighbourhood.
void PlainLdm::collect_cluster(std::size_t first_voxel) {
  const auto label = static_cast<int>(clusters_.size());
  ldm::VoxelIndex low = voxel_of(window_, first_voxel);
  ldm::VoxelIndex high = low;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::vector<std::size_t> members{first_voxel};
  labels_[first_voxel] = label;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const ldm::VoxelIndex voxel = voxel_of(window_, members[m]);
    low = low.cwiseMin(voxel);
    high = high.cwiseMax(voxel);
    sum += (voxel.cast<double>().array() + 0.5).matrix();
    const ldm::VoxelBox neighbours{voxel.array() - 1, Eigen::Vector3i::Constant(3)};
    for_each_voxel(neighbours, [&](const ldm::VoxelIndex& next) {
      if (!window_.contains(next)) return;
      const std::size_t i = window_.index(next);
      if (labels_[i] != kNobody || !is_occupied(i)) return;
      labels_[i] = label;
      members.push_back(i);
    });
  }
  const double resolution = parameters_.map.resolution;
  ldm::Cluster found;
  found.voxels = static_cast<std::int32_t>(members.size());
  found.position = (sum / found.voxels * resolution).cast<float>();
  found.size = ((high - low).cast<double>().array() + 1).matrix().cast<float>() *
               static_cast<float>(resolution);
  clusters_.push_back(found);
}

/// A cluster takes over the rest of the predicted cluster with which it shares most voxels.
void PlainLdm::inherit_rests() {
  std::vector<std::map<int, int>> shared(clusters_.size());  // predicted cluster -> voxels
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == kNobody || predicted_labels_[i] == kNobody) continue;
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

/// See eq. 16 and 17.
void PlainLdm::estimate_velocities() {
  const std::vector<Eigen::Vector3d> velocities =
      particles_.cluster_velocities(window_, labels_, clusters_.size());
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    clusters_[c].velocity = velocities[c].cast<float>();
    clusters_[c].dynamic = velocities[c].norm() >= parameters_.clusters.static_below;
  }
  if (parameters_.clusters.readjust) particles_.readjust(window_, labels_, velocities);
}

void PlainLdm::read(ldm::LocalMap& map) const {
  map.window = window_;
  map.resolution = parameters_.map.resolution;
  map.occupancy.clear();
  for (const double l : log_odds_) map.occupancy.push_back(static_cast<float>(to_probability(l)));
  map.labels.assign(labels_.begin(), labels_.end());
  map.clusters = clusters_;
}

}  // namespace reference
