#include "tests/reference/plain_particles.h"

#include "tests/reference/plain_log_odds.h"
#include "tests/reference/voxel_boxes.h"

namespace reference {

/// Of the particles in a voxel or a cluster: what the weighted mean of eq. 12 and 16 needs.
struct PlainParticles::VelocitySum {
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
    return weighted_velocity / weight;
  }
};

PlainParticles::PlainParticles(const ldm::Parameters& parameters)
    : parameters_(parameters.particles),
      resolution_(parameters.map.resolution),
      occupied_above_(parameters.clusters.occupied_above),
      random_(parameters.execution.seed) {}

void PlainParticles::scatter(const ldm::VoxelBox& window) {
  particles_.clear();
  const auto count = static_cast<std::size_t>(parameters_.count);
  while (particles_.size() < count) {
    particles_.push_back(
        {somewhere_in(window.origin, window.size), noise(), 1 / static_cast<double>(count)});
  }
  remove_outside(window);  // rounding may carry one across the last wall
}

void PlainParticles::predict(double dt) {
  for (Particle& particle : particles_) {
    particle.velocity += noise();
    particle.position += dt * particle.velocity;
  }
}

void PlainParticles::remove_outside(const ldm::VoxelBox& window) {
  const Eigen::Array3d low = window.origin.cast<double>();
  const Eigen::Array3d high = low + window.size.cast<double>().array();
  std::erase_if(particles_, [&](const Particle& particle) {
    const Eigen::Array3d p = particle.position / resolution_;
    return (p < low).any() || (p >= high).any();
  });
}

void PlainParticles::update(const ldm::VoxelBox& window, const std::vector<double>& log_odds) {
  std::vector<VelocitySum> voxels(log_odds.size());
  for (Particle& particle : particles_) {
    const std::size_t i = index_in(window, particle);
    particle.weight += to_probability(log_odds[i]);
    voxels[i].add(particle);
  }
  if (parameters_.birth) add_births(window, log_odds, voxels);
  normalise_weights();
}

void PlainParticles::add_births(const ldm::VoxelBox& window, const std::vector<double>& log_odds,
                                const std::vector<VelocitySum>& voxels) {
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const double p = to_probability(log_odds[i]);
    if (!(p > occupied_above_)) continue;
    const ldm::VoxelIndex voxel = voxel_of(window, i);
    for (std::int64_t n = voxels[i].particles; n < parameters_.min_per_voxel; ++n) {
      particles_.push_back(
          {somewhere_in(voxel, Eigen::Vector3i::Ones()), voxels[i].mean() + noise(), p});
    }
  }
  remove_outside(window);
}

void PlainParticles::normalise_weights() {
  double sum = 0;
  for (const Particle& particle : particles_) sum += particle.weight;
  for (Particle& particle : particles_) particle.weight /= sum;
}

void PlainParticles::resample() {
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

std::vector<Eigen::Vector3d> PlainParticles::cluster_velocities(const ldm::VoxelBox& window,
                                                                const std::vector<int>& labels,
                                                                std::size_t clusters) const {
  std::vector<VelocitySum> sums(clusters);
  for (const Particle& particle : particles_) {
    const int c = labels[index_in(window, particle)];
    if (c != kNobody) sums[static_cast<std::size_t>(c)].add(particle);
  }
  std::vector<Eigen::Vector3d> velocities;
  for (const VelocitySum& sum : sums) velocities.push_back(sum.mean());
  return velocities;
}

void PlainParticles::readjust(const ldm::VoxelBox& window, const std::vector<int>& labels,
                              const std::vector<Eigen::Vector3d>& velocities) {
  for (Particle& particle : particles_) {
    const int c = labels[index_in(window, particle)];
    if (c != kNobody) particle.velocity = velocities[static_cast<std::size_t>(c)];
  }
}

/// A draw from N(0, Sigma) [m/s].
Eigen::Vector3d PlainParticles::noise() {
  std::normal_distribution<double> normal;
  const double x = parameters_.sigma_xy * normal(random_);
  const double y = parameters_.sigma_xy * normal(random_);
  const double z = parameters_.sigma_z * normal(random_);
  return {x, y, z};
}

/// A point drawn evenly from a box of voxels, world frame [m].
Eigen::Vector3d PlainParticles::somewhere_in(const ldm::VoxelIndex& low,
                                             const Eigen::Vector3i& size) {
  std::uniform_real_distribution<double> share(0, 1);
  const double x = low.x() + share(random_) * size.x();
  const double y = low.y() + share(random_) * size.y();
  const double z = low.z() + share(random_) * size.z();
  return Eigen::Vector3d(x, y, z) * resolution_;
}

std::size_t PlainParticles::index_in(const ldm::VoxelBox& window, const Particle& particle) const {
  return window.index(ldm::voxel_at(particle.position, resolution_));
}

}  // namespace reference
