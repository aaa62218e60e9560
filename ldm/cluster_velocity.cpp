#include "ldm/cluster_velocity.h"

namespace ldm {

Velocity cluster_velocity(std::span<const Run> runs, const RingIndex& index,
                          const Particles& particles) {
  VelocitySum sum;
  for (const Run& run : runs) {
    for_each_slot(index, run, [&](std::size_t slot) { sum.add(particles.velocity_sum(slot)); });
  }
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
    for (const Run& run : runs) {
      for_each_slot(index, run,
                    [&](std::size_t slot) { particles.set_velocity(slot, cluster.velocity); });
    }
  }
}

}  // namespace ldm
