/// Class Particles from its weights to its next generation: paper Eq. (11), (13)-(15).
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "ldm/copy_places.h"
#include "ldm/log_odds.h"
#include "ldm/machine/processor.h"
#include "ldm/particles.h"

namespace ldm {
namespace {

constexpr double kOneWeight = 1 << 24;
constexpr int kClaimBits = 31;        // of a particle's claim: it fits 32
constexpr std::size_t kStretch = 32;  // slots looked at as one
constexpr int kToWrite = 1;           // of a prefetch

}  // namespace

/// Number of particles in a slot, after `predict`.
std::uint32_t Particles::count(std::size_t slot) const {
  std::uint32_t sum = 0;
  for (const Part& part : parts_) sum += part.count[slot];
  return sum;
}

std::uint32_t Particles::updated_weight(float l) const {
  return static_cast<std::uint32_t>(std::llround(kOneWeight * (prior_weight_ + probability(l))));
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
      const auto [begin, end] = stretch(part);
      std::vector<std::uint32_t>& count = parts_[static_cast<std::size_t>(part)].count;
      for (std::size_t i = begin; i < end; ++i) ++count[particles_[i].slot];
    });
  }
  parallel_.run([&](int part) { weigh_part(part, log_odds); });
  for (std::size_t part = 1; part < parts_.size(); ++part) found().append(parts_[part].found);
}

void Particles::Claimants::reserve(std::size_t most_voxels, std::size_t usual_births) {
  voxels.reserve(most_voxels);
  claims.reserve(most_voxels);
  births.reserve(usual_births);
}

void Particles::Claimants::clear() {
  voxels.clear();
  claims.clear();
  births.clear();
  total_weight = 0;
}

void Particles::Claimants::append(const Claimants& behind) {
  const auto before = static_cast<std::uint32_t>(voxels.size());
  voxels.insert(voxels.end(), behind.voxels.begin(), behind.voxels.end());
  claims.insert(claims.end(), behind.claims.begin(), behind.claims.end());
  for (const Births& b : behind.births) births.push_back({before + b.place, b.count, b.claim});
  total_weight += behind.total_weight;
}

void Particles::weigh_part(int part, std::span<const float> log_odds) {
  Claimants& found = parts_[static_cast<std::size_t>(part)].found;
  found.clear();
  if (part == 0) {
    found.voxels.emplace_back();
    found.claims.push_back(0);
  }
  float l = 0;
  std::uint32_t weight = updated_weight(l);
  std::array<std::uint32_t, kStretch> slots;
  const auto [begin, end] = parallel_.share(part, log_odds.size());
  for (std::size_t first = begin; first < end; first += kStretch) {
    const std::size_t last = std::min(first + kStretch, end);
    if (is_empty(log_odds, first, last)) continue;
    const std::size_t listed = list_claimants(log_odds, first, last, slots);
    for (std::size_t i = 0; i < listed; ++i) {
      // Nine of ten have the log-odds of the one before: unknown, or at a clamp.
      if (log_odds[slots[i]] != l) {
        l = log_odds[slots[i]];
        weight = updated_weight(l);
      }
      weigh_slot(slots[i], l, weight, found);
    }
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

/// Into `slots`, those of [first, last) that hold particles, or in which some are to be born; how
/// many. Requires room for all. Without a branch, as which of them do looks like chance.
std::size_t Particles::list_claimants(std::span<const float> log_odds, std::size_t first,
                                      std::size_t last, std::span<std::uint32_t> slots) const {
  const auto may_bear = static_cast<std::size_t>(min_per_voxel_ != 0);
  std::size_t n = 0;
  for (std::size_t slot = first; slot < last; ++slot) {
    slots[n] = static_cast<std::uint32_t>(slot);
    const auto holds = static_cast<std::size_t>(count(slot) != 0);
    const auto bears = static_cast<std::size_t>(log_odds[slot] > occupied_above_) & may_bear;
    n += holds | bears;
  }
  return n;
}

void Particles::weigh_slot(std::uint32_t slot, float l, std::uint32_t weight,
                           Claimants& found) const {
  const std::uint32_t count = this->count(slot);
  found.total_weight += std::uint64_t{count} * weight;
  if (count < min_per_voxel_ && l > occupied_above_) {
    const auto place = static_cast<std::uint32_t>(found.voxels.size());
    const auto prior = static_cast<std::uint32_t>(kOneWeight * prior_weight_);
    found.births.push_back({place, min_per_voxel_ - count, weight - prior});
    found.total_weight += std::uint64_t{found.births.back().count} * found.births.back().claim;
  }
  found.voxels.push_back({slot, 0});
  found.claims.push_back(weight);
}

/// Lays the claims of all voxels end to end; in a voxel, those of part after part, then the births.
void Particles::claim() {
  Claimants& found = this->found();
  const double per_weight = static_cast<double>(n_init_) / static_cast<double>(found.total_weight);
  const double most = *std::max_element(found.claims.begin(), found.claims.end()) * per_weight;
  claim_bits_ = kClaimBits - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(most)));
  // Even claims leave the lowest bit to kHasBirths.
  const double half_per_weight = std::ldexp(per_weight, claim_bits_ - 1);
  for (Part& part : parts_) {
    part.next.resize(found.voxels.size());
    part.next[0] = 0;
    part.before.assign(found.births.size(), VelocitySum{});
  }
  const RandomStream stream(seed_, Purpose::kResampling, frame_);
  std::uint64_t next = stream.bits(0) >> (64 - claim_bits_);
  auto births = found.births.begin();
  for (std::size_t i = 1; i < found.voxels.size(); ++i) {
    Voxel& voxel = found.voxels[i];
    // What is claimed beyond N_init, a trace of rounding, is lost.
    voxel.first = static_cast<std::uint32_t>(std::min<std::uint64_t>(next >> claim_bits_, n_init_));
    const bool has_births = births != found.births.end() && births->place == i;
    const std::uint32_t each =
        2 * normalised(found.claims[i], half_per_weight) | (has_births ? kHasBirths : 0);
    std::uint32_t count = 0;
    for (Part& part : parts_) {
      part.next[i] = next;
      count += part.count[voxel.slot];
      next += std::uint64_t{part.count[voxel.slot]} * each;
    }
    // Particles that still name a voxel with none are forgotten ones: they claim nothing.
    found.claims[i] = count == 0 ? 0 : each;
    if (has_births) {
      births->claim = 2 * normalised(births->claim, half_per_weight);
      next += std::uint64_t{births->count} * births->claim;
      ++births;
    }
    places()[voxel.slot] = static_cast<std::uint32_t>(i);
  }
}

void Particles::resample(const RingIndex& index) {
  claim();
  parallel_.run([this](int part) { resample_part(part); });
  bear(index);
  particles_.swap(resampled_);
}

/// Block by block: where the copies of all go; the third copies and more at once, the first two
/// while the next block claims. In between their places come into the first cache: stores would
/// wait for them one after the other, a sixth of the pass. Claiming waits for what it loads,
/// copying for what it stores: together they take 0.85 of the time.
LDM_TWICE void Particles::resample_part(int number) {
  Part& part = parts_[static_cast<std::size_t>(number)];
  const std::uint32_t* const place_of = places().data();
  const std::uint32_t* const claims = found().claims.data();
  std::uint64_t* const next_of = part.next.data();
  auto* const resampled = reinterpret_cast<std::byte*>(resampled_.data());
  const int bits = claim_bits_ - CopyPlaces::kSizeBits;  // 1 or more: N_init < 2^26 (parameters.h)
  CopyPlaces copies(n_init_, n_init_ + kSpare * (1 + static_cast<std::size_t>(number)));
  const auto claim = [&](std::size_t i, const Particle& p) {
    const std::uint32_t place = place_of[p.slot];
    const std::uint32_t each = claims[place];
    const std::uint64_t next = next_of[place];
    next_of[place] = next + each;
    copies.claim(i, next >> bits, (next + each) >> bits);
    __builtin_prefetch(resampled + (next >> bits), kToWrite);
    if ((each & kHasBirths) != 0) add_to_births(place, p, part);
  };
  const auto copy = [&](std::size_t i, const Particle& p) {
    const ParticleCopy particle(p);
    particle.put(resampled + copies.one(i));
    particle.put(resampled + copies.other(i));
  };
  std::span<const Particle> previous;
  const auto [begin, end] = stretch(number);
  for (std::size_t from = begin; from < end; from += CopyPlaces::kBlock) {
    const auto block = all().subspan(from, std::min(CopyPlaces::kBlock, end - from));
    const std::size_t both = std::min(block.size(), previous.size());
    for (std::size_t i = 0; i < both; ++i) {
      claim(i, block[i]);
      copy(i, previous[i]);
    }
    for (std::size_t i = both; i < block.size(); ++i) claim(i, block[i]);       // the first block
    for (std::size_t i = both; i < previous.size(); ++i) copy(i, previous[i]);  // the last
    // Behind the last of all, the places are those of a block before: at worst a needless third.
    const bool third = copies.choose();
    for (std::size_t i = 0; third && i < block.size(); ++i) {
      const ParticleCopy particle(block[i]);
      std::uint32_t to = copies.one(i) + 2 * CopyPlaces::kSize;
      for (; to < copies.end(i); to += CopyPlaces::kSize) particle.put(resampled + to);
    }
    previous = block;
  }
  for (std::size_t i = 0; i < previous.size(); ++i) copy(i, previous[i]);
}

/// `p` is one of those that were in a voxel before births. Few are, so this stays out of the loop.
[[gnu::noinline]] void Particles::add_to_births(std::uint32_t place, const Particle& p,
                                                Part& part) const {
  const auto births =
      std::lower_bound(found().births.begin(), found().births.end(), place,
                       [](const Births& b, std::uint32_t number) { return b.place < number; });
  part.before[static_cast<std::size_t>(births - found().births.begin())].add(p);
}

/// The newborn of each voxel, behind the copies of those that were there.
void Particles::bear(const RingIndex& index) {
  const RandomStream stream(seed_, Purpose::kBirth, frame_);
  const VoxelBox slots{Eigen::Vector3i::Zero(), index.window().size};
  for (std::size_t i = 0; i < found().births.size(); ++i) {
    const Births& births = found().births[i];
    const std::uint32_t slot = found().voxels[births.place].slot;
    const Eigen::Vector3i corner = slots.voxel(slot) * (1 << fraction_bits_);
    std::uint64_t next = parts_.back().next[births.place];
    VelocitySum before;
    for (const Part& part : parts_) before.add(part.before[i]);
    for (std::uint32_t birth = 0; birth < births.count; ++birth) {
      const std::uint64_t begin = next >> claim_bits_;
      next += births.claim;
      const std::uint64_t end = std::min<std::uint64_t>(next >> claim_bits_, n_init_);
      if (begin >= end) continue;
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
             Particle::quantised(mean.x()),
             Particle::quantised(mean.y()),
             Particle::quantised(mean.z()),
             slot};
  noise_.change(p, stream.bits(draw + 1));
  return p;
}

}  // namespace ldm
