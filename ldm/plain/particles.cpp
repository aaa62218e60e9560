#include "ldm/plain/particles.h"

#include "ldm/plain/log_odds.h"

namespace ldm::plain {

/// Of the particles in a voxel or a cluster: what the weighted mean of eq. 12 and 16 needs.
struct Particles::VelocitySum {
  Eigen::Vector3d weighted_velocity = Eigen::Vector3d::Zero();
  double weight = 0;
  int particles = 0;

  void add(const Particle& particle) {
    weighted_velocity += particle.weight * particle.velocity;
    weight += particle.weight;
    ++particles;
  }
  Eigen::Vector3d mean() const {
    if (particles == 0) return Eigen::Vector3d::Zero();
    return weighted_velocity / weight;  // V = sum of w v / sum of w.  Eq. (12)
  }
};

Particles::Particles(const Parameters& parameters)
    : parameters_(parameters.particles),
      resolution_(parameters.map.resolution),
      occupied_above_(parameters.clusters.occupied_above),
      random_(parameters.execution.seed) {}

void Particles::scatter(const VoxelBox& window) {
  particles_.clear();
  const auto count = static_cast<std::size_t>(parameters_.count);
  while (particles_.size() < count) {
    particles_.push_back(
        {somewhere_in(window.origin, window.size), noise(), 1 / static_cast<double>(count)});
  }
  remove_outside(window);  // rounding may carry one across the last wall
}

void Particles::predict(double dt) {
  for (Particle& particle : particles_) {
    particle.velocity += noise();                 // v_k = v_{k-1} + sigma.  Eq. (4)
    particle.position += dt * particle.velocity;  // x_k = x_{k-1} + dt v_k.  Eq. (5)
  }
}

void Particles::remove_outside(const VoxelBox& window) {
  const Eigen::Array3d low = window.origin.cast<double>();
  const Eigen::Array3d high = low + window.size.cast<double>().array();
  std::erase_if(particles_, [&](const Particle& particle) {
    const Eigen::Array3d p = particle.position / resolution_;
    return (p < low).any() || (p >= high).any();
  });
}

void Particles::update(const VoxelBox& window, const std::vector<double>& log_odds) {
  std::vector<VelocitySum> voxels(log_odds.size());
  for (Particle& particle : particles_) {
    const std::size_t i = index_in(window, particle);
    particle.weight += probability(log_odds[i]);  // w_k = w_{k-1} + P(Occ).  Eq. (11)
    voxels[i].add(particle);
  }
  if (parameters_.birth) add_births(window, log_odds, voxels);
  normalise_weights();
}

void Particles::add_births(const VoxelBox& window, const std::vector<double>& log_odds,
                           const std::vector<VelocitySum>& voxels) {
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const double p = probability(log_odds[i]);
    if (!(p > occupied_above_)) continue;
    const VoxelIndex voxel = window.voxel(i);
    for (std::int64_t n = voxels[i].particles; n < parameters_.min_per_voxel; ++n) {
      const Eigen::Vector3d velocity = voxels[i].mean() + noise();  // v = V + sigma.  Eq. (13)
      particles_.push_back({somewhere_in(voxel, Eigen::Vector3i::Ones()), velocity, p});
    }
  }
  remove_outside(window);
}

void Particles::normalise_weights() {
  double sum = 0;                                                      // mu
  for (const Particle& particle : particles_) sum += particle.weight;  // mu = sum of w.  Eq. (15)
  for (Particle& particle : particles_) particle.weight /= sum;        // w / mu.  Eq. (14)
}

void Particles::resample() {
  std::vector<double> weights;
  for (const Particle& particle : particles_) weights.push_back(particle.weight);
  std::discrete_distribution<std::size_t> by_weight(weights.begin(), weights.end());
  const auto count = static_cast<std::size_t>(parameters_.count);
  std::vector<Particle> selected;
  while (selected.size() < count) {
    selected.push_back(particles_[by_weight(random_)]);
    selected.back().weight = 1 / static_cast<double>(count);
  }
  particles_ = selected;
}

std::vector<Eigen::Vector3d> Particles::cluster_velocities(const VoxelBox& window,
                                                           const std::vector<int>& labels,
                                                           std::size_t clusters) const {
  std::vector<VelocitySum> sums(clusters);
  for (const Particle& particle : particles_) {
    const int c = labels[index_in(window, particle)];
    if (c != kNoCluster) sums[static_cast<std::size_t>(c)].add(particle);
  }
  std::vector<Eigen::Vector3d> velocities;
  velocities.reserve(clusters);
  for (const VelocitySum& sum : sums) velocities.push_back(sum.mean());  // Eq. (16)
  return velocities;
}

void Particles::readjust(const VoxelBox& window, const std::vector<int>& labels,
                         const std::vector<Eigen::Vector3d>& velocities) {
  for (Particle& particle : particles_) {
    const int c = labels[index_in(window, particle)];
    if (c == kNoCluster) continue;
    particle.velocity = velocities[static_cast<std::size_t>(c)];  // v = V of its cluster.  Eq. (17)
  }
}

/// A draw from N(0, Sigma) [m/s].
Eigen::Vector3d Particles::noise() {
  std::normal_distribution<double> normal;
  const double x = parameters_.sigma_xy * normal(random_);
  const double y = parameters_.sigma_xy * normal(random_);
  const double z = parameters_.sigma_z * normal(random_);
  return {x, y, z};
}

/// A point drawn evenly from a box of voxels, world frame [m].
Eigen::Vector3d Particles::somewhere_in(const VoxelIndex& low, const Eigen::Vector3i& size) {
  std::uniform_real_distribution<double> share(0, 1);
  const double x = low.x() + share(random_) * size.x();
  const double y = low.y() + share(random_) * size.y();
  const double z = low.z() + share(random_) * size.z();
  return Eigen::Vector3d(x, y, z) * resolution_;
}

std::size_t Particles::index_in(const VoxelBox& window, const Particle& particle) const {
  return window.index(voxel_at(particle.position, resolution_));
}

}  // namespace ldm::plain
