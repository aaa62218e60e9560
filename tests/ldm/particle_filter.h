#pragma once
/// A particle filter over a map that a test writes by hand, and statistics of its particles.
#include <vector>

#include "ldm/particles.h"
#include "tests/ldm/random_inputs.h"

namespace ldm {

/// Velocity of a particle [m/s].
inline Eigen::Vector3d velocity(const Particle& p) {
  return Eigen::Vector3d(p.vx, p.vy, p.vz) * Particle::kVelocityQuantum;
}

/// Mean and covariance of a sample.
struct Moments {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  explicit Moments(const std::vector<Eigen::Vector3d>& sample) {
    const auto n = static_cast<double>(sample.size());
    for (const Eigen::Vector3d& x : sample) mean += x / n;
    for (const Eigen::Vector3d& x : sample) covariance += (x - mean) * (x - mean).transpose() / n;
  }
};

inline ParticleParameters particle_parameters(std::int64_t count, double sigma) {
  ParticleParameters parameters;
  parameters.count = count;
  parameters.sigma_xy = parameters.sigma_z = sigma;
  return parameters;
}

/// Map and particles, as LocalDynamicMap holds them.
struct ParticleFilter {
  ParticleFilter(const MapParameters& map, const ParticleParameters& parameters,
                 std::uint64_t seed = 1, const VoxelIndex& centre = VoxelIndex::Zero())
      : log_odds(placed(map.voxels, centre)),
        particles(map, parameters, {}, {.threads = 1, .seed = seed}, log_odds.index()) {}

  void update() {
    particles.weigh(log_odds);
    particles.resample(log_odds.index());
  }
  void frame(double dt) {
    particles.predict(dt, log_odds.index());
    update();
  }
  void recenter(const VoxelIndex& c) {
    log_odds.recenter(c, [&](std::size_t first, std::size_t n) { particles.forget(first, n); });
  }
  void set_all_velocities(const Velocity& v) {
    particles.set_velocity(0, log_odds.cells().size(), CommonVelocity(v));
  }
  std::vector<Particle> snapshot() const {
    return {particles.all().begin(), particles.all().end()};
  }
  /// Particles in each slot, before or after resampling.
  std::vector<std::size_t> counts() const {
    std::vector<std::size_t> counts(log_odds.cells().size(), 0);
    for (const Particle& p : particles.all()) {
      if (p.slot < counts.size()) ++counts[p.slot];
    }
    return counts;
  }
  Eigen::Vector3d position(const Particle& p) const {
    return particles.position(p, log_odds.index());
  }
  std::size_t gone() const { return log_odds.cells().size(); }  ///< slot of those that left
  std::vector<Eigen::Vector3d> velocities() const {
    std::vector<Eigen::Vector3d> sample;
    for (const Particle& p : particles.all()) sample.push_back(velocity(p));
    return sample;
  }
  std::vector<Eigen::Vector3d> positions() const {
    std::vector<Eigen::Vector3d> sample;
    for (const Particle& p : particles.all()) sample.push_back(position(p));
    return sample;
  }

  RingBuffer<float> log_odds;
  Particles particles;

 private:
  static RingBuffer<float> placed(const Eigen::Vector3i& voxels, const VoxelIndex& centre) {
    RingBuffer<float> map(voxels);
    map.recenter(centre);
    return map;
  }
};

}  // namespace ldm
