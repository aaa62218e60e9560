#include "ldm/occupancy_prediction.h"

#include <algorithm>
#include <cmath>

#include "ldm/log_odds.h"

namespace ldm {
namespace {

constexpr std::size_t kUsualClusters = 256;
constexpr std::size_t kUsualVoxels = 4096;  // of clusters

bool inside(const VoxelIndex& local, const Eigen::Vector3i& size) {
  return (local.array() >= 0).all() && (local.array() < size.array()).all();
}

std::size_t slot_of(const RingIndex& index, const VoxelIndex& local) {
  return index.slot_of_local(local.x(), local.y(), local.z());
}

Eigen::Vector3i nearest_whole(const Eigen::Vector3f& v) {
  return (v.array() + 0.5F).floor().cast<int>();
}

}  // namespace

OccupancyPrediction::OccupancyPrediction(const MapParameters& map,
                                         const SensorModelParameters& sensor,
                                         const PredictionParameters& prediction)
    : resolution_(map.resolution), sensor_(sensor), prediction_(prediction), size_(map.voxels) {
  const std::size_t count = RingIndex(map.voxels).count();
  owner_ = SparseNumbers(count);
  if (prediction.sub_voxel == SubVoxelMotion::kTrilinear) share_.assign(count, 0);
  // Room for what is usual; a map with more of it takes more once.
  for (auto* const rests : {&rests_, &old_rests_}) rests->reserve(kUsualClusters);
  motions_.reserve(kUsualClusters);
  static_.reserve(kUsualClusters);
  shared_.reserve(kUsualClusters);
  taken_.reserve(kUsualVoxels);
  owned_.reserve(kUsualVoxels);
}

void OccupancyPrediction::predict(double dt, const Clustering& clusters,
                                  RingBuffer<float>& log_odds) {
  plan(dt, clusters.clusters());
  take(clusters, log_odds);
  if (prediction_.sub_voxel == SubVoxelMotion::kTrilinear) {
    splat(log_odds);
  } else {
    put(log_odds);
  }
  own(log_odds.index(), clusters);
}

/// How far each cluster moves in this frame, and what rest it keeps.
void OccupancyPrediction::plan(double dt, const std::vector<Cluster>& clusters) {
  const SubVoxelMotion way = prediction_.sub_voxel;
  const auto voxels_per_mps = static_cast<float>(std::min(dt / resolution_, 1e9));
  motions_.clear();
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const Velocity& v = clusters[c].velocity;
    Motion motion{Eigen::Vector3f::Zero(), Eigen::Vector3i::Zero(), false};
    if (way != SubVoxelMotion::kNone && v.norm() >= static_cast<float>(prediction_.min_speed)) {
      motion.displacement = v * voxels_per_mps;
      if (way == SubVoxelMotion::kResidual) motion.displacement += rests_[c];
      // Beyond the map there is nothing to tell apart; the bound keeps the integers small.
      const Eigen::Vector3f bound = size_.cast<float>();
      motion.displacement = motion.displacement.cwiseMax(-bound).cwiseMin(bound);
      motion.whole = nearest_whole(motion.displacement);
      motion.moves = way == SubVoxelMotion::kTrilinear ? !motion.displacement.isZero(0)
                                                       : !motion.whole.isZero();
    }
    rests_[c] = motion.displacement - motion.whole.cast<float>();
    motions_.push_back(motion);
  }
}

/// Takes the log-odds of all moving clusters out of the map.
void OccupancyPrediction::take(const Clustering& clusters, RingBuffer<float>& log_odds) {
  taken_.clear();
  for (const Run& run : clusters.runs()) {
    if (!motions_[static_cast<std::size_t>(run.cluster)].moves) continue;
    for (int x = run.x_begin; x < run.x_end; ++x) {
      const VoxelIndex local(x, run.y, run.z);
      float& l = log_odds.in_slot(slot_of(log_odds.index(), local));
      taken_.push_back({local, l, run.cluster});
      l = 0;
    }
  }
}

/// Puts it back, moved by whole voxels.
void OccupancyPrediction::put(RingBuffer<float>& log_odds) const {
  for (const Taken& taken : taken_) {
    const VoxelIndex to = taken.voxel + motions_[static_cast<std::size_t>(taken.cluster)].whole;
    if (!inside(to, size_)) continue;
    float& l = log_odds.in_slot(slot_of(log_odds.index(), to));
    l = std::max(l, taken.log_odds);
  }
}

/// Puts it back, each voxel's probability shared out to the eight voxels its moved cube overlaps.
void OccupancyPrediction::splat(RingBuffer<float>& log_odds) {
  touched_.clear();
  for (const Taken& taken : taken_) {
    const Eigen::Vector3f& d = motions_[static_cast<std::size_t>(taken.cluster)].displacement;
    const Eigen::Vector3f low = d.array().floor();
    const Eigen::Vector3f part = d - low;
    const auto p = static_cast<float>(probability(taken.log_odds));
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i up(corner & 1, corner >> 1 & 1, corner >> 2);
      const VoxelIndex to = taken.voxel + low.cast<int>() + up;
      const float weight = (up.array() != 0).select(part.array(), 1 - part.array()).prod();
      if (weight == 0 || !inside(to, size_)) continue;
      const std::size_t slot = slot_of(log_odds.index(), to);
      if (share_[slot] == 0) touched_.push_back(slot);
      share_[slot] += weight * p;
    }
  }
  const auto low = static_cast<float>(sensor_.log_odds_min);
  const auto high = static_cast<float>(sensor_.log_odds_max);
  for (const std::size_t slot : touched_) {
    const float p = std::min(share_[slot], 0.9999F);
    float& l = log_odds.in_slot(slot);
    l = std::max(l, std::clamp(static_cast<float>(ldm::log_odds(p)), low, high));
    share_[slot] = 0;
  }
}

/// Notes which slots the predicted clusters stand in, for `inherit` and for eq. 10.
void OccupancyPrediction::own(const RingIndex& index, const Clustering& clusters) {
  owner_.clear(owned_);
  owned_.clear();
  const SparseNumbers::Writer owner = owner_.writer();
  for (const Run& run : clusters.runs()) {
    const auto c = static_cast<std::size_t>(run.cluster);
    for (int x = run.x_begin; x < run.x_end; ++x) {
      const VoxelIndex to = VoxelIndex(x, run.y, run.z) + motions_[c].whole;
      if (!inside(to, size_)) continue;
      const std::size_t slot = slot_of(index, to);
      owner.set(slot, 1 + static_cast<std::uint32_t>(c));
      owned_.push_back(slot);
    }
  }
}

void OccupancyPrediction::forget(std::size_t first, std::size_t n) {
  owner_.clear(first, n);
}

void OccupancyPrediction::inherit(const RingIndex& index, const Clustering& clusters) {
  static_.clear();
  for (const Cluster& cluster : clusters.clusters()) static_.push_back(cluster.dynamic ? 0 : 1);
  old_rests_.swap(rests_);
  rests_.assign(clusters.clusters().size(), Eigen::Vector3f::Zero());
  shared_.assign(old_rests_.size(), 0);
  for (std::size_t c = 0; c < rests_.size(); ++c) {
    std::int32_t most = 0;
    const auto count = [&](std::size_t slot) {
      if (owner_[slot] == 0) return;
      const std::size_t owner = owner_[slot] - 1;
      if (++shared_[owner] <= most) return;
      most = shared_[owner];
      rests_[c] = old_rests_[owner];
    };
    const auto forget_count = [&](std::size_t slot) {
      if (owner_[slot] != 0) shared_[owner_[slot] - 1] = 0;
    };
    for_each_slot(index, clusters.runs_of(c), count);
    for_each_slot(index, clusters.runs_of(c), forget_count);
  }
}

}  // namespace ldm
