#include "ldm/cluster_velocity.h"

namespace ldm {

Velocity cluster_velocity(std::span<const Run> runs, const RingIndex& index,
                          const Particles& particles) {
  VelocitySum sum;
  for_each_stretch(index, runs,
                   [&](std::size_t slot, std::size_t n) { sum.add(particles.in_slots(slot, n)); });
  return sum.mean();
}

void set_cluster_velocities(const ClusterParameters& parameters, const RingIndex& index,
                            Particles& particles, Clustering& clustering) {
  for (std::size_t c = 0; c < clustering.clusters().size(); ++c) {
    const std::span<const Run> runs = clustering.runs_of(c);
    Cluster& cluster = clustering.clusters()[c];
    cluster.velocity = cluster_velocity(runs, index, particles);
    cluster.dynamic = cluster.velocity.norm() >= static_cast<float>(parameters.static_below);
    if (!parameters.readjust) continue;
    const CommonVelocity velocity(cluster.velocity);
    for_each_stretch(index, runs, [&](std::size_t slot, std::size_t n) {
      particles.set_velocity(slot, n, velocity);
    });
  }
}

}  // namespace ldm
