#pragma once
/// Occupancy prediction: clusters move, and their occupancy with them: paper Sec. 3.2, Fig. 3.
#include <cstdint>
#include <span>
#include <vector>

#include "ldm/clustering.h"
#include "ldm/occupancy_update.h"
#include "ldm/parameters.h"
#include "ldm/ring_buffer.h"

namespace ldm {

/// Moves the occupancy of each cluster by its velocity times dt, in the way of SubVoxelMotion; a
/// cluster slower than `prediction.min_speed` stays.
///
/// Deviation: Fig. 3 shows moves by whole voxels only; at 10 Hz a cluster covers less than one. By
/// default (`residual`) the rest that is not moved yet stays with the cluster, and passes to the
/// next frame's cluster that shares most voxels with it.
class OccupancyPrediction {
 public:
  OccupancyPrediction(const MapParameters& map, const SensorModelParameters& sensor,
                      const PredictionParameters& prediction);

  /// Move the clusters of k - 1, as `inherit` last saw them, by dt [s]. Vacated voxels become
  /// unknown; where a moved voxel meets another the larger log-odds stays; what leaves the window
  /// is lost. Cost: the clustered voxels.
  void predict(double dt, const Clustering& clusters, RingBuffer<float>& log_odds);

  /// Forget slots [first, first + n): their voxels left the window.
  void forget(std::size_t first, std::size_t n);

  /// Where the objects of k - 1 stand after `predict`, until `inherit`.
  StaticVoxels kept() const { return {&owner_, static_}; }

  /// Remember which clusters of k are static, and hand the sub-voxel rests on to them, once their
  /// velocities and `dynamic` are set.
  void inherit(const RingIndex& index, const Clustering& clusters);

 private:
  void plan(double dt, const std::vector<Cluster>& clusters);
  void take(const Clustering& clusters, RingBuffer<float>& log_odds);
  void put(RingBuffer<float>& log_odds) const;
  void splat(RingBuffer<float>& log_odds);
  void own(const RingIndex& index, const Clustering& clusters);

  struct Motion {
    Eigen::Vector3f displacement;  // of this frame, with the rest of the frame before [voxels]
    Eigen::Vector3i whole;         // its nearest whole voxels
    bool moves;
  };
  struct Taken {
    VoxelIndex voxel;  // counted from the window's lowest
    float log_odds;
    std::int32_t cluster;
  };

  double resolution_;
  SensorModelParameters sensor_;
  PredictionParameters prediction_;
  Eigen::Vector3i size_;
  std::vector<Motion> motions_;             // per cluster of k - 1
  std::vector<Eigen::Vector3f> rests_;      // per cluster: displacement not moved yet [voxels]
  std::vector<std::uint8_t> static_;        // per cluster
  std::vector<Eigen::Vector3f> old_rests_;  // those of k - 1, while inheriting
  std::vector<Taken> taken_;
  SparseNumbers owner_;               // per slot: 1 + number of the predicted cluster; 0 for none
  std::vector<std::size_t> owned_;    // slots with an owner, and some that lost it
  std::vector<std::int32_t> shared_;  // per cluster of k - 1: voxels shared, while counting
  std::vector<float> share_;          // per slot: P splat onto it; trilinear only
  std::vector<std::size_t> touched_;  // slots with a share
};

}  // namespace ldm
