#include "ldm/particles.h"

#include <algorithm>
#include <cassert>

#include "ldm/log_odds.h"

namespace ldm {
namespace {

constexpr std::size_t kUsualBirths = 4096;  // voxels; a frame with more takes more memory

}  // namespace

Particles::Particles(const MapParameters& map, const ParticleParameters& particles,
                     const ClusterParameters& clusters, const ExecutionParameters& execution,
                     const RingIndex& index)
    : resolution_(map.resolution),
      n_init_(static_cast<std::size_t>(particles.count)),
      prior_weight_(1 / static_cast<double>(n_init_)),
      min_per_voxel_(particles.birth ? static_cast<std::uint32_t>(particles.min_per_voxel) : 0),
      occupied_above_(static_cast<float>(log_odds(clusters.occupied_above))),
      fraction_bits_(ParticleMotion::fraction_bits(map.voxels)),
      noise_(particles),
      seed_(execution.seed),
      parallel_(execution.threads),
      parts_(static_cast<std::size_t>(parallel_.parts())),
      particles_(n_init_ + kSpare * (1 + parts_.size())),
      resampled_(particles_.size()) {
  const std::size_t most_voxels = std::min(index.count(), n_init_) + 1;
  for (Part& part : parts_) {
    part.counted.in_slot = SparseNumbers(index.count() + 1);
    part.weighed.reserve(most_voxels, kUsualBirths);
    part.next.reserve(most_voxels);
    part.before.reserve(kUsualBirths);
  }
  claimed_.each.reserve(most_voxels);
  claimed_.births.reserve(kUsualBirths);
  scatter_uniformly(index);
}

void Particles::scatter_uniformly(const RingIndex& index) {
  const RandomStream stream(seed_, Purpose::kInitial, frame_);
  const Eigen::Vector3i& n = index.window().size;
  const auto along = [&](int axis, std::uint64_t bits) {  // a position from 16 random bits
    const auto extent = static_cast<std::uint64_t>(n[axis]) << fraction_bits_;
    return static_cast<std::uint16_t>(((bits & 0xffff) * extent) >> 16);
  };
  for (std::size_t i = 0; i < n_init_; ++i) {
    const std::uint64_t at = stream.bits(2 * i);
    Particle& p = particles_[i];
    p = {along(0, at), along(1, at >> 16), along(2, at >> 32), 0, 0, 0, 0};
    noise_.change(p, stream.bits(2 * i + 1));
    p.slot = static_cast<std::uint32_t>(
        (p.x >> fraction_bits_) +
        n.x() * ((p.y >> fraction_bits_) + n.y() * (p.z >> fraction_bits_)));
  }
  std::sort(particles_.begin(), particles_.begin() + static_cast<std::ptrdiff_t>(n_init_),
            [](const Particle& a, const Particle& b) { return a.slot < b.slot; });
}

Parallel::Share Particles::stretch(int part) const {
  const auto [begin, end] = parallel_.share(part, (n_init_ + 1) / 2);
  return {2 * begin, std::min(2 * end, n_init_)};
}

void Particles::predict(double dt, const RingIndex& index) {
  ++frame_;
  const ParticleMotion motion(index, fraction_bits_, dt / resolution_);
  // Placed particles move on: the memory goes back to the counts.
  if (!placed_.in_slot.empty()) std::swap(parts_[0].counted.in_slot, placed_.in_slot);
  parallel_.for_each_part([&](int part) { predict_part(part, motion); });
}

void Particles::predict_part(int part, const ParticleMotion& motion) {
  SparseNumbers& counts = parts_[static_cast<std::size_t>(part)].counted.in_slot;
  counts.clear();
  const auto [begin, end] = stretch(part);
  const RandomStream stream(seed_, Purpose::kPrediction, frame_);
  const PredictionPass pass{particles_.data(), counts.writer(), noise_, stream, motion};
  pass.move(begin, end);
  if (end % 2 == 1)
    --pass.count.numbers[particles_[end].slot];  // a spare place made up the last pair
  counts.clear(motion.constants().gone[0],
               1);  // those that left the map, and what the pass adds to them
}

void Particles::forget(std::size_t first, std::size_t n) {
  for (Part& part : parts_) part.counted.in_slot.clear(first, n);
}

Parallel::Share Particles::range_of(std::size_t first, std::size_t n) const {
  assert(!placed_.in_slot.empty());
  const SparseNumbers& voxel = placed_.in_slot;
  std::size_t last = first + n;
  while (first < last && voxel[first] == 0) ++first;
  while (first < last && voxel[last - 1] == 0) --last;
  if (first == last) return {0, 0};
  // What is claimed beyond N_init, a trace of rounding, is lost.
  const auto end_of = [this](std::uint32_t number) {
    return std::min<std::size_t>(parts_.back().next[number] >> claimed_.bits, n_init_);
  };
  return {end_of(voxel[first] - 1), end_of(voxel[last - 1])};
}

Velocity Particles::voxel_velocity(std::size_t slot) const {
  VelocitySum sum;
  sum.add(in_slot(slot));
  return sum.mean();
}

void Particles::set_velocity(std::size_t first, std::size_t n, const CommonVelocity& v) {
  const auto [begin, end] = range_of(first, n);
  v.give({particles_.data() + begin, end - begin});
}

Eigen::Vector3d Particles::position(const Particle& p, const RingIndex& index) const {
  const Eigen::Vector3i at(p.x, p.y, p.z);
  Eigen::Vector3d local;
  for (int axis = 0; axis < 3; ++axis) {
    const int extent = index.window().size[axis] << fraction_bits_;
    const int from_lowest = at[axis] - (index.origin_slot()[axis] << fraction_bits_);
    local[axis] = (from_lowest < 0 ? from_lowest + extent : from_lowest) + 0.5;
  }
  return (local / (1 << fraction_bits_) + index.window().origin.cast<double>()) * resolution_;
}

}  // namespace ldm
