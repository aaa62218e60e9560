#pragma once
/// The local dynamic map of the paper's Fig. 1 written plainly: to read first, and the oracle that
/// the fast one in ldm/ is held to.
///
/// As one would write it from the paper in an afternoon: structures of doubles, dense grids that
/// are copied when they move, the generators and distributions of the standard library. It shares
/// no code with the fast map but the types, the parameters, the check of the input, and the
/// identity of clusters, which is no step of the paper's.
#include <optional>
#include <vector>

#include "ldm/cluster_tracker.h"
#include "ldm/mapper.h"
#include "ldm/parameters.h"
#include "ldm/plain/measurement_flags.h"
#include "ldm/plain/particles.h"

namespace ldm::plain {

class LocalDynamicMap final : public Mapper {
 public:
  /// @throws InvalidInput on a parameter out of its range, and on the sub-voxel motions
  /// `round` and `trilinear`, which are not written here.
  explicit LocalDynamicMap(const Parameters& parameters);

  void update(const Scan& scan, StageListener* listener = nullptr) override;
  void read(LocalMap& map) const override;

 private:
  void predict_occupancy(double dt);
  std::vector<Eigen::Vector3i> plan_steps(double dt);
  void update_movement(const VoxelIndex& uav);
  void update_occupancy(const std::vector<VoxelFlag>& flags);
  bool was_static(std::size_t index) const;
  bool is_occupied(std::size_t index) const;
  void cluster();
  void collect_cluster(std::size_t first_voxel);
  void inherit_rests();
  void estimate_velocities();

  Parameters parameters_;
  std::optional<double> time_;  // of the last scan [s]
  VoxelBox window_;
  std::vector<double> log_odds_;       // per voxel, in window order, like all grids here
  std::vector<int> labels_;            // cluster of each voxel, or kNoCluster
  std::vector<int> predicted_labels_;  // clusters of k - 1 where they stand after the prediction
  std::vector<Cluster> clusters_;
  std::vector<Eigen::Vector3d> rests_;  // per cluster: displacement not moved yet [voxels]
  Particles particles_;
  std::vector<bool> static_;  // per cluster
  ClusterTracker tracker_;
};

}  // namespace ldm::plain
