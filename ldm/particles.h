#pragma once
/// The particle filter that finds velocities: paper Eq. (2)-(5), (11)-(15), Sec. 3.4.
///
/// One frame is two passes over the particles. `predict` moves them in place and counts them by
/// voxel; `resample` copies each to where its copies belong, which sorts them by voxel as well. In
/// between, `weigh` walks the voxels: after resampling all weights are equal, so the weight of
/// eq. 11 is a number of the voxel, and no particle has to store one.
///
/// The loop of `predict` is in particle_motion.cpp, what comes of the particles' weights in
/// resampling.cpp, all else in particles.cpp.
///
/// Threads share the particles out in stretches. Each counts its own, and finds its place in the
/// comb behind the stretches before it: the result is the same bits for any number of threads.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ldm/machine/parallel.h"
#include "ldm/machine/random.h"
#include "ldm/parameters.h"
#include "ldm/particle.h"
#include "ldm/particle_motion.h"
#include "ldm/resampling.h"
#include "ldm/ring_buffer.h"

namespace ldm {

class Particles {
 public:
  /// N_init particles, evenly over the window of `index`, velocities N(0, Sigma) (Sec. 3.1).
  Particles(const MapParameters& map, const ParticleParameters& particles,
            const ClusterParameters& clusters, const ExecutionParameters& execution,
            const RingIndex& index);

  /// Move all particles by dt [s]; those that leave the window of `index` are gone. Cost: one pass.
  void predict(double dt, const RingIndex& index);
  /// The voxels of slots [first, first + n) left the map (movement update), and their particles.
  void forget(std::size_t first, std::size_t n);
  /// Weights and births per voxel. If no particle is left in the map, N_init are drawn anew over
  /// the window first. Cost: one pass over the map.
  void weigh(const RingBuffer<float>& log_odds);
  /// Back to N_init particles, sorted by slot, in proportion to weight. Cost: one pass.
  /// Deviation: the paper draws each particle on its own; systematic resampling (Kitagawa, 1996)
  /// has the same expectation with less noise.
  void resample(const RingIndex& index);

  /// w_k = w_{k-1} + P(Occ) with w_{k-1} = 1 / N_init, in units of 2^-24.  Eq. (11)
  std::uint32_t updated_weight(float log_odds) const;
  /// w / mu: the part of N_init that a weight claims, in the unit of `claim_per_weight`. Always
  /// rounded up: the claims reach N_init.  Eq. (14)
  static std::uint32_t normalised(std::uint32_t weight, double claim_per_weight);
  /// mu_k: the sum of all weights after `weigh`, in units of 2^-24.  Eq. (15)
  std::uint64_t total_weight() const { return weighed().total_weight; }

  /// All particles; sorted by slot after `resample`.
  std::span<const Particle> all() const { return {particles_.data(), n_init_}; }
  /// The particles in slots [first, first + n), after `resample`. Cost: a look at the empty slots
  /// at both ends.
  std::span<const Particle> in_slots(std::size_t first, std::size_t n) const {
    const auto [begin, end] = range_of(first, n);
    return all().subspan(begin, end - begin);
  }
  std::span<const Particle> in_slot(std::size_t slot) const { return in_slots(slot, 1); }
  /// V_k^j: mean velocity [m/s] of the particles in a slot after `resample`, or zero.  Eq. (12)
  Velocity voxel_velocity(std::size_t slot) const;
  /// Give all particles in slots [first, first + n) one velocity [m/s].  Eq. (17)
  void set_velocity(std::size_t first, std::size_t n, const CommonVelocity& v);
  /// Position of a particle in the window of `index` [m], world frame; the middle of its quantum.
  Eigen::Vector3d position(const Particle& p, const RingIndex& index) const;

 private:
  // Spare places behind the particles: some to make up the last pair, and some for each part. They
  // fill a cache line, so that threads do not share one.
  static constexpr std::size_t kSpare = 64 / sizeof(Particle);
  /// One thread's stretch of the particles, and of the slots.
  struct Part {
    Counted counted;
    Weighed weighed;                  // all of them, gathered, in that of the first part
    std::vector<std::uint64_t> next;  // beside the voxels: where its next particle's claim begins;
                                      // of the last part, in the end, where the next voxel's does
    std::vector<VelocitySum> before;  // beside the births: of the particles here before resampling
  };

  /// The particles of a part: whole pairs, but for the last of all.
  Parallel::Share stretch(int part) const;
  void scatter_uniformly(const RingIndex& index);
  void predict_part(int part, const ParticleMotion& motion);
  void weigh_part(int part, const RingBuffer<float>& map);
  bool is_empty(const RingBuffer<float>& map, std::size_t brick) const;
  std::array<std::uint32_t, kBrick> counts_in(std::size_t first, std::size_t n) const;
  std::size_t list_slots(std::span<const float> log_odds,
                         const std::array<std::uint32_t, kBrick>& counts,
                         std::array<std::uint32_t, kBrick>& slots) const;
  void weigh_slot(std::uint32_t slot, std::uint32_t count, float l, std::uint32_t weight,
                  Weighed& weighed) const;
  void claim();
  void resample_part(int part);
  void place_newborn(const RingIndex& index);
  /// Evenly in the voxel at `corner`, with V_k^j + sigma. `draw`: number of the first of two draws
  /// of `stream`.  Eq. (13)
  Particle newborn(std::uint32_t slot, const Velocity& mean, const Eigen::Vector3i& corner,
                   const RandomStream& stream, std::uint64_t draw) const;
  /// Of the particles in slots [first, first + n).
  Parallel::Share range_of(std::size_t first, std::size_t n) const;
  void add_to_births(std::uint32_t voxel, const Particle& p, Part& part) const;
  /// Of all slots, after `weigh`.
  Weighed& weighed() { return parts_[0].weighed; }
  const Weighed& weighed() const { return parts_[0].weighed; }

  double resolution_;
  std::size_t n_init_;
  double prior_weight_;          // 1 / N_init
  std::uint32_t min_per_voxel_;  // births up to so many; 0 for none
  float occupied_above_;         // log-odds
  int fraction_bits_;
  VelocityNoise noise_;
  std::uint64_t seed_;
  std::uint64_t frame_ = 0;

  Parallel parallel_;
  std::vector<Part> parts_;
  std::vector<Particle> particles_;  // N_init, and spare places
  std::vector<Particle> resampled_;
  Claimed claimed_;
  Placed placed_;
};

}  // namespace ldm
