#pragma once
/// The local dynamic map of the paper's Fig. 1 written plainly: the slow oracle of ldm/.
///
/// As one would write it from the paper in an afternoon: structures of doubles, dense grids that
/// are copied when they move, the generators and distributions of the standard library. It shares
/// no code with the map it is held against but the types, the parameters and the check of the
/// input.
#include <optional>
#include <vector>

#include "ldm/mapper.h"
#include "ldm/parameters.h"
#include "tests/reference/plain_flags.h"
#include "tests/reference/plain_particles.h"

namespace reference {

class PlainLdm final : public ldm::Mapper {
 public:
  /// @throws ldm::InvalidInput on a parameter out of its range, and on the sub-voxel motions
  /// `round` and `trilinear`, which are not written here.
  explicit PlainLdm(const ldm::Parameters& parameters);

  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  void read(ldm::LocalMap& map) const override;

 private:
  void predict_occupancy(double dt);
  std::vector<Eigen::Vector3i> plan_steps(double dt);
  void update_movement(const ldm::VoxelIndex& uav);
  void update_occupancy(const std::vector<VoxelFlag>& flags);
  bool was_static(std::size_t index) const;
  bool is_occupied(std::size_t index) const;
  void cluster();
  void collect_cluster(std::size_t first_voxel);
  void inherit_rests();
  void estimate_velocities();

  ldm::Parameters parameters_;
  std::optional<double> time_;  // of the last scan [s]
  ldm::VoxelBox window_;
  std::vector<double> log_odds_;       // per voxel, in window order, like all grids here
  std::vector<int> labels_;            // cluster of each voxel, or kNobody
  std::vector<int> predicted_labels_;  // clusters of k - 1 where they stand after the prediction
  std::vector<ldm::Cluster> clusters_;
  std::vector<Eigen::Vector3d> rests_;  // per cluster: displacement not moved yet [voxels]
  PlainParticles particles_;
};

}  // namespace reference
