#pragma once
/// The particle filter of paper Sec. 3.1, 3.3.3 and 3.4 written plainly.
#include <random>
#include <vector>

#include "ldm/parameters.h"

namespace reference {

/// Label of a voxel that belongs to no cluster.
inline constexpr int kNobody = -1;

/// Grids are in window order.
class PlainParticles {
 public:
  explicit PlainParticles(const ldm::Parameters& parameters);

  bool empty() const { return particles_.empty(); }
  std::size_t size() const { return particles_.size(); }

  /// N_init particles, evenly over the window (Sec. 3.1).
  void scatter(const ldm::VoxelBox& window);
  /// See eq. 4 and 5. `dt` in [s].
  void predict(double dt);
  void remove_outside(const ldm::VoxelBox& window);
  /// Weights and births, see eq. 11 to 15. All particles lie in the window.
  void update(const ldm::VoxelBox& window, const std::vector<double>& log_odds);
  /// N_init independent draws from the discrete distribution of the weights (Sec. 3.4); ldm/ draws
  /// systematically instead.
  void resample();
  /// Velocity of each of `clusters` clusters, see eq. 16; zero where there are no particles. [m/s]
  std::vector<Eigen::Vector3d> cluster_velocities(const ldm::VoxelBox& window,
                                                  const std::vector<int>& labels,
                                                  std::size_t clusters) const;
  /// See eq. 17.
  void readjust(const ldm::VoxelBox& window, const std::vector<int>& labels,
                const std::vector<Eigen::Vector3d>& velocities);

 private:
  struct Particle {
    Eigen::Vector3d position;  // world frame [m]
    Eigen::Vector3d velocity;  // [m/s]
    double weight;
  };
  struct VelocitySum;

  void add_births(const ldm::VoxelBox& window, const std::vector<double>& log_odds,
                  const std::vector<VelocitySum>& voxels);
  void normalise_weights();
  Eigen::Vector3d noise();
  Eigen::Vector3d somewhere_in(const ldm::VoxelIndex& low, const Eigen::Vector3i& size);
  std::size_t index_in(const ldm::VoxelBox& window, const Particle& particle) const;

  ldm::ParticleParameters parameters_;
  double resolution_;
  double occupied_above_;
  std::mt19937_64 random_;
  std::vector<Particle> particles_;
};

}  // namespace reference
