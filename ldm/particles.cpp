#include "ldm/particles.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ldm/log_odds.h"

namespace ldm {
namespace {

constexpr double kOneWeight = 1 << 24;
constexpr int kClaimBits = 31;              // of a particle's claim: it fits 32
constexpr std::size_t kUsualBirths = 4096;  // voxels; a frame with more takes more memory
constexpr std::size_t kStretch = 32;        // slots looked at as one

/// Fraction bits of a position that fits 16 bits for any voxel of the map.
int fraction_bits(const Eigen::Vector3i& voxels) {
  return 16 - std::bit_width(static_cast<unsigned>(voxels.maxCoeff() - 1));
}

/// a if `first`, else b, by arithmetic: the compiler makes branches of other forms.
std::uint64_t choose(bool first, std::uint64_t a, std::uint64_t b) {
  return b ^ ((a ^ b) & -std::uint64_t{first});
}

std::int16_t quantised(float v) {
  const float units = v / static_cast<float>(Particle::kVelocityQuantum);
  return static_cast<std::int16_t>(std::lround(std::clamp(units, -32768.0F, 32767.0F)));
}

}  // namespace

Particles::Particles(const MapParameters& map, const ParticleParameters& particles,
                     const ClusterParameters& clusters, const ExecutionParameters& execution,
                     const RingIndex& index)
    : resolution_(map.resolution),
      n_init_(static_cast<std::size_t>(particles.count)),
      min_per_voxel_(static_cast<std::uint32_t>(particles.min_per_voxel)),
      birth_(particles.birth),
      occupied_above_(static_cast<float>(log_odds(clusters.occupied_above))),
      fraction_bits_(fraction_bits(map.voxels)),
      noise_(particles),
      seed_(execution.seed),
      parallel_(execution.threads),
      parts_(static_cast<std::size_t>(parallel_.parts())),
      particles_(n_init_ + kSpare * (1 + parts_.size())),
      resampled_(particles_.size()) {
  voxels_.reserve(std::min(index.count(), n_init_) + 1);
  claims_.reserve(voxels_.capacity());
  births_.reserve(kUsualBirths);
  for (Part& part : parts_) {
    part.count.resize(index.count() + 1);
    part.next.reserve(voxels_.capacity());
    part.before.reserve(births_.capacity());
  }
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
    ParticleLanes lanes(p);
    lanes.velocity = noise_.changed(lanes.velocity, stream.bits(2 * i + 1));
    lanes.store(static_cast<std::uint32_t>(
                    (p.x >> fraction_bits_) +
                    n.x() * ((p.y >> fraction_bits_) + n.y() * (p.z >> fraction_bits_))),
                p);
  }
  std::sort(particles_.begin(), particles_.begin() + static_cast<std::ptrdiff_t>(n_init_),
            [](const Particle& a, const Particle& b) { return a.slot < b.slot; });
}

void Particles::predict(double dt, const RingIndex& index) {
  ++frame_;
  const ParticleMotion motion(index, fraction_bits_, dt / resolution_);
  parallel_.run([&](int part) { predict_part(part, motion); });
}

/// `motion` by value: nothing that the loop writes can be a part of it, so it stays in registers.
void Particles::predict_part(int part, ParticleMotion motion) {
  const RandomStream stream(seed_, Purpose::kPrediction, frame_);
  std::vector<std::uint32_t>& counts = parts_[static_cast<std::size_t>(part)].count;
  std::fill(counts.begin(), counts.end(), 0U);
  std::uint32_t* const count = counts.data();
  Particle* const particles = particles_.data();
  const auto [begin, end] = parallel_.share(part, n_init_);
  for (std::size_t i = begin; i < end; ++i) {
    ParticleLanes p(particles[i]);
    p.velocity = noise_.changed(p.velocity, stream.bits(i));
    const std::uint32_t slot = motion.move(p.position, p.velocity);
    p.store(slot, particles[i]);
    ++count[slot];
  }
  counts.back() = 0;  // those that left the map
}

void Particles::forget(std::size_t first, std::size_t n) {
  for (Part& part : parts_) {
    std::fill_n(part.count.begin() + static_cast<std::ptrdiff_t>(first), n, 0U);
  }
}

/// Number of particles in a slot, after `predict`.
std::uint32_t Particles::count(std::size_t slot) const {
  std::uint32_t sum = 0;
  for (const Part& part : parts_) sum += part.count[slot];
  return sum;
}

std::uint32_t Particles::updated_weight(float l) const {
  return static_cast<std::uint32_t>(
      std::llround(kOneWeight * (1 / static_cast<double>(n_init_) + probability(l))));
}

std::uint32_t Particles::normalised(std::uint32_t weight, double claim_per_weight) {
  return static_cast<std::uint32_t>(weight * claim_per_weight) + 1;
}

void Particles::weigh(const RingBuffer<float>& map) {
  const std::span<const float> log_odds = map.cells();
  const auto has_none = [](const Part& part) {
    return std::all_of(part.count.begin(), part.count.end(), [](auto n) { return n == 0; });
  };
  if (std::all_of(parts_.begin(), parts_.end(), has_none)) {
    scatter_uniformly(map.index());
    parallel_.run([this](int part) {
      const auto [begin, end] = parallel_.share(part, n_init_);
      std::vector<std::uint32_t>& count = parts_[static_cast<std::size_t>(part)].count;
      for (std::size_t i = begin; i < end; ++i) ++count[particles_[i].slot];
    });
  }
  voxels_.assign(1, Voxel{});
  claims_.assign(1, 0);
  births_.clear();
  total_weight_ = 0;
  for (std::size_t first = 0; first < log_odds.size(); first += kStretch) {
    const std::size_t last = std::min(first + kStretch, log_odds.size());
    if (!is_empty(log_odds, first, last)) weigh_slots(log_odds, first, last);
  }
}

/// True if nothing is, nor will be born, in slots [first, last). Vectors of them are looked at:
/// that makes the stage twice as fast at 128^3, where most voxels are empty.
bool Particles::is_empty(std::span<const float> log_odds, std::size_t first,
                         std::size_t last) const {
  std::uint32_t any = 0;
  for (const Part& part : parts_) {
    for (std::size_t slot = first; slot < last; ++slot) any |= part.count[slot];
  }
  for (std::size_t slot = first; slot < last; ++slot) {
    any |= static_cast<std::uint32_t>(log_odds[slot] > occupied_above_);
  }
  return any == 0;
}

void Particles::weigh_slots(std::span<const float> log_odds, std::size_t first, std::size_t last) {
  const auto prior = static_cast<std::uint32_t>(kOneWeight / static_cast<double>(n_init_));
  for (std::size_t slot = first; slot < last; ++slot) {
    const std::uint32_t count = this->count(slot);
    const bool needs_births = birth_ && count < min_per_voxel_ && log_odds[slot] > occupied_above_;
    if (count == 0 && !needs_births) continue;
    const std::uint32_t weight = updated_weight(log_odds[slot]);
    total_weight_ += std::uint64_t{count} * weight;
    if (needs_births) {
      const auto place = static_cast<std::uint32_t>(voxels_.size());
      births_.push_back({place, min_per_voxel_ - count, weight - prior});
      total_weight_ += std::uint64_t{births_.back().count} * births_.back().claim;
    }
    voxels_.push_back({static_cast<std::uint32_t>(slot), 0});
    claims_.push_back(weight);
  }
}

/// Lays the claims of all voxels end to end; in a voxel, those of part after part, then the births.
void Particles::claim() {
  const double per_weight = static_cast<double>(n_init_) / static_cast<double>(total_weight_);
  const double most = *std::max_element(claims_.begin(), claims_.end()) * per_weight;
  claim_bits_ = kClaimBits - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(most)));
  const double claim_per_weight = std::ldexp(per_weight, claim_bits_);
  for (Part& part : parts_) {
    part.next.assign(1, 0);
    part.before.assign(births_.size(), VelocitySum{});
  }
  const RandomStream stream(seed_, Purpose::kResampling, frame_);
  std::uint64_t next = stream.bits(0) >> (64 - claim_bits_);
  auto births = births_.begin();
  for (std::size_t i = 1; i < voxels_.size(); ++i) {
    Voxel& voxel = voxels_[i];
    // What is claimed beyond N_init, a trace of rounding, goes to a spare place and is lost.
    voxel.first = static_cast<std::uint32_t>(std::min<std::uint64_t>(next >> claim_bits_, n_init_));
    claims_[i] = normalised(claims_[i], claim_per_weight);
    std::uint32_t count = 0;
    for (Part& part : parts_) {
      part.next.push_back(next);
      count += part.count[voxel.slot];
      next += std::uint64_t{part.count[voxel.slot]} * claims_[i];
    }
    // Particles that still name a voxel with none are forgotten ones: they claim nothing.
    if (count == 0) claims_[i] = 0;
    const bool has_births = births != births_.end() && births->place == i;
    if (has_births) {
      births->claim = normalised(births->claim, claim_per_weight);
      next += std::uint64_t{births->count} * births->claim;
      ++births;
    }
    places()[voxel.slot] =
        static_cast<std::uint32_t>(i) | (has_births && count > 0 ? kHasBirths : 0);
  }
}

void Particles::resample(const RingIndex& index) {
  claim();
  parallel_.run([this](int part) { resample_part(part); });
  bear(index);
  particles_.swap(resampled_);
}

void Particles::resample_part(int number) {
  Part& part = parts_[static_cast<std::size_t>(number)];
  const std::uint32_t* const place_of = places().data();
  const std::uint32_t* const claims = claims_.data();
  std::uint64_t* const next_of = part.next.data();
  const Particle* const particles = particles_.data();
  Particle* const resampled = resampled_.data();
  const std::uint64_t spare = n_init_ + kSpare * static_cast<std::uint64_t>(1 + number);
  const int bits = claim_bits_;
  const auto [begin, end] = parallel_.share(number, n_init_);
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t place = place_of[particles[i].slot];
    std::uint64_t& next = next_of[place & ~kHasBirths];
    const std::uint64_t first = next >> bits;
    next += claims[place & ~kHasBirths];
    const std::uint64_t last = next >> bits;
    // Most have no copy, one or two, as if by chance: a processor that guesses which loses more
    // time than by two copies that may go to the spare place. This halves the time of the pass.
    const std::uint64_t copies = last - first;
    const ParticleCopy particle(particles[i]);
    particle.put(resampled[choose(copies > 0, first, spare)]);
    particle.put(resampled[choose(copies > 1, first + 1, spare)]);
    for (std::uint64_t to = first + 2; to < last; ++to) particle.put(resampled[to]);
    if ((place & kHasBirths) != 0) before(place & ~kHasBirths, part).add(particles[i]);
  }
}

/// The sum that belongs to the births of a voxel.
VelocitySum& Particles::before(std::uint32_t place, Part& part) const {
  const auto births =
      std::lower_bound(births_.begin(), births_.end(), place,
                       [](const Births& b, std::uint32_t p) { return b.place < p; });
  return part.before[static_cast<std::size_t>(births - births_.begin())];
}

/// The newborn of each voxel, behind the copies of those that were there.
void Particles::bear(const RingIndex& index) {
  const RandomStream stream(seed_, Purpose::kBirth, frame_);
  const Eigen::Vector3i& n = index.window().size;
  for (std::size_t i = 0; i < births_.size(); ++i) {
    const Births& births = births_[i];
    const std::uint32_t slot = voxels_[births.place].slot;
    const auto cell = static_cast<int>(slot);
    const Eigen::Vector3i corner =
        Eigen::Vector3i(cell % n.x(), cell / n.x() % n.y(), cell / n.x() / n.y()) *
        (1 << fraction_bits_);
    std::uint64_t next = parts_.back().next[births.place];
    VelocitySum before;
    for (const Part& part : parts_) before.add(part.before[i]);
    for (std::uint32_t birth = 0; birth < births.count; ++birth) {
      const std::uint64_t begin = next >> claim_bits_;
      next += births.claim;
      const std::uint64_t end = next >> claim_bits_;
      if (begin == end) continue;
      const std::uint64_t draw = (std::uint64_t{slot} << 32) + 2 * birth;
      const Particle p = newborn(slot, before.mean(), corner, stream, draw);
      for (std::uint64_t to = begin; to < end; ++to) resampled_[to] = p;
    }
  }
}

Particle Particles::newborn(std::uint32_t slot, const Velocity& mean, const Eigen::Vector3i& corner,
                            const RandomStream& stream, std::uint64_t draw) const {
  const std::uint64_t at = stream.bits(draw);
  const auto along = [&](int axis, std::uint64_t random) {
    const std::uint64_t within = random & ((std::uint64_t{1} << fraction_bits_) - 1);
    return static_cast<std::uint16_t>(corner[axis] + static_cast<int>(within));
  };
  Particle p{along(0, at),
             along(1, at >> 16),
             along(2, at >> 32),
             quantised(mean.x()),
             quantised(mean.y()),
             quantised(mean.z()),
             slot};
  ParticleLanes lanes(p);
  lanes.velocity = noise_.changed(lanes.velocity, stream.bits(draw + 1));
  lanes.store(slot, p);
  return p;
}

std::span<Particle> Particles::slot_range(std::size_t slot) {
  const std::size_t place = places()[slot] & ~kHasBirths;
  if (place == 0) return {};
  const std::size_t first = voxels_[place].first;
  const std::size_t last = place + 1 < voxels_.size() ? voxels_[place + 1].first : n_init_;
  return {particles_.data() + first, last - first};
}

std::span<const Particle> Particles::in_slot(std::size_t slot) const {
  return const_cast<Particles*>(this)->slot_range(slot);
}

VelocitySum Particles::velocity_sum(std::size_t slot) const {
  VelocitySum sum;
  sum.add(in_slot(slot));
  return sum;
}

void Particles::set_velocity(std::size_t slot, const Velocity& v) {
  const std::int16_t vx = quantised(v.x());
  const std::int16_t vy = quantised(v.y());
  const std::int16_t vz = quantised(v.z());
  for (Particle& p : slot_range(slot)) {
    p.vx = vx;
    p.vy = vy;
    p.vz = vz;
  }
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
