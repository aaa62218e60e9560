#pragma once
/// Velocities of clusters, and particles readjusted to them: paper Sec. 3.5, Eq. (16)-(17).
#include "ldm/clustering.h"
#include "ldm/particles.h"

namespace ldm {

/// V^cluster,j: mean velocity [m/s] of the particles in the cluster's voxels; after resampling all
/// weights are equal. Zero if there are none.  Eq. (16)
Velocity cluster_velocity(std::span<const Run> runs, const RingIndex& index,
                          const Particles& particles);

/// Set velocity and `dynamic` of every cluster of `clustering`, and give its particles that
/// velocity (eq. 17) if `parameters.readjust`. `particles` as after Particles::resample. Cost: the
/// particles in clusters.
void set_cluster_velocities(const ClusterParameters& parameters, const RingIndex& index,
                            Particles& particles, Clustering& clustering);

}  // namespace ldm
