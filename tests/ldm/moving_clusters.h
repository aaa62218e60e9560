#pragma once
/// Clusters with velocities given by hand, and the prediction of their occupancy.
#include <vector>

#include "ldm/occupancy_prediction.h"
#include "tests/ldm/random_inputs.h"

namespace ldm {

class MovingClusters {
 public:
  MovingClusters(const Eigen::Vector3i& voxels, const PredictionParameters& prediction,
                 float background = 0)
      : map_(map_of(voxels)),
        log_odds_(voxels),
        clustering_(map_, {}),
        prediction_(map_, {}, prediction) {
    std::fill(log_odds_.cells().begin(), log_odds_.cells().end(), background);
  }

  void set(const VoxelIndex& v, float l) { log_odds_.at(v) = l; }
  float at(const VoxelIndex& v) const { return log_odds_.at(v); }
  /// The voxels above a log-odds, in window order.
  std::vector<VoxelIndex> above(float l) const {
    std::vector<VoxelIndex> voxels;
    for_each_voxel(log_odds_.index().window(), [&](const VoxelIndex& v, std::size_t) {
      if (at(v) > l) voxels.push_back(v);
    });
    return voxels;
  }

  /// The end of a frame: clusters are found, get these velocities in turn, and inherit their rests.
  void find(const std::vector<Velocity>& velocities) {
    clustering_.find(log_odds_);
    std::vector<Cluster>& clusters = clustering_.clusters();
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      clusters[c].velocity = velocities.at(c);
      clusters[c].dynamic = velocities[c].norm() >= 0.2F;
    }
    prediction_.inherit(log_odds_.index(), clustering_);
  }
  void predict(double dt) { prediction_.predict(dt, clustering_, log_odds_); }
  void recenter(const VoxelIndex& c) {
    log_odds_.recenter(c, [&](std::size_t first, std::size_t n) { prediction_.forget(first, n); });
  }

  /// The voxels in which static objects stand after `predict`, in window order.
  std::vector<VoxelIndex> kept() const {
    std::vector<VoxelIndex> voxels;
    for_each_voxel(log_odds_.index().window(), [&](const VoxelIndex& v, std::size_t) {
      if (prediction_.kept().at(log_odds_.index().slot(v))) voxels.push_back(v);
    });
    return voxels;
  }

 private:
  MapParameters map_;
  RingBuffer<float> log_odds_;
  Clustering clustering_;
  OccupancyPrediction prediction_;
};

}  // namespace ldm
