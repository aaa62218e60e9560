#pragma once
/// The particle filter of paper Sec. 3.1, 3.3.3 and 3.4 written plainly; see ldm/particles.h.
#include <random>
#include <vector>

#include "ldm/parameters.h"

namespace ldm::plain {

/// Label of a voxel that belongs to no cluster.
inline constexpr int kNoCluster = -1;

/// Grids are in window order.
class Particles {
 public:
  explicit Particles(const Parameters& parameters);

  bool empty() const { return particles_.empty(); }
  std::size_t size() const { return particles_.size(); }

  /// N_init particles, evenly over the window (Sec. 3.1).
  void scatter(const VoxelBox& window);
  /// Velocities get noise, then all move on by `dt` [s] (Sec. 3.2).
  void predict(double dt);
  void remove_outside(const VoxelBox& window);
  /// Weights and births (Sec. 3.3.3). All particles lie in the window.
  void update(const VoxelBox& window, const std::vector<double>& log_odds);
  /// N_init independent draws from the discrete distribution of the weights (Sec. 3.4); the fast
  /// filter draws systematically instead.
  void resample();
  /// Velocity of each of `clusters` clusters [m/s]; zero where there are no particles (Sec. 3.5).
  std::vector<Eigen::Vector3d> cluster_velocities(const VoxelBox& window,
                                                  const std::vector<int>& labels,
                                                  std::size_t clusters) const;
  /// Particles in a cluster take its velocity.
  void readjust(const VoxelBox& window, const std::vector<int>& labels,
                const std::vector<Eigen::Vector3d>& velocities);

 private:
  struct Particle {
    Eigen::Vector3d position;  // x, world frame [m].  Eq. (2)
    Eigen::Vector3d velocity;  // v [m/s].  Eq. (3)
    double weight;             // w
  };
  struct VelocitySum;

  void add_births(const VoxelBox& window, const std::vector<double>& log_odds,
                  const std::vector<VelocitySum>& voxels);
  void normalise_weights();
  Eigen::Vector3d noise();
  Eigen::Vector3d somewhere_in(const VoxelIndex& low, const Eigen::Vector3i& size);
  std::size_t index_in(const VoxelBox& window, const Particle& particle) const;

  ParticleParameters parameters_;
  double resolution_;
  double occupied_above_;
  std::mt19937_64 random_;
  std::vector<Particle> particles_;
};

}  // namespace ldm::plain
