#include "ldm/resampling.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "ldm/log_odds.h"
#include "ldm/machine/processor.h"
#include "ldm/particles.h"

namespace ldm {
namespace {

constexpr double kOneWeight = 1 << 24;
constexpr int kClaimBits = 31;  // of a particle's claim: it fits 32
constexpr int kToWrite = 1;     // of a prefetch

}  // namespace

std::uint32_t Particles::updated_weight(float l) const {
  return static_cast<std::uint32_t>(std::llround(kOneWeight * (prior_weight_ + probability(l))));
}

std::uint32_t Particles::normalised(std::uint32_t weight, double claim_per_weight) {
  return static_cast<std::uint32_t>(weight * claim_per_weight) + 1;
}

void Particles::weigh(const RingBuffer<float>& map) {
  const auto has_none = [](const Part& part) { return part.counted.in_slot.all_zero(); };
  if (std::all_of(parts_.begin(), parts_.end(), has_none)) {
    scatter_uniformly(map.index());
    parallel_.for_each_part([this](int part) {
      const auto [begin, end] = stretch(part);
      const auto count = parts_[static_cast<std::size_t>(part)].counted.in_slot.writer();
      for (std::size_t i = begin; i < end; ++i) count.add_one(particles_[i].slot);
    });
  }
  parallel_.for_each_part([&](int part) { weigh_part(part, map); });
  for (std::size_t part = 1; part < parts_.size(); ++part) weighed().append(parts_[part].weighed);
}

void Particles::weigh_part(int part, const RingBuffer<float>& map) {
  const std::span<const float> log_odds = map.cells();
  Weighed& weighed = parts_[static_cast<std::size_t>(part)].weighed;
  weighed.clear();
  if (part == 0) weighed.voxels.push_back({0, 0});
  float l = 0;
  std::uint32_t weight = updated_weight(l);
  std::array<std::uint32_t, kBrick> slots;
  const auto [begin, end] = parallel_.share(part, bricks_of(log_odds.size()));
  for (std::size_t brick = begin; brick < end; ++brick) {
    if (is_empty(map, brick)) continue;
    const std::size_t first = brick * kBrick;
    const auto in_brick = log_odds.subspan(first, std::min(kBrick, log_odds.size() - first));
    const std::array<std::uint32_t, kBrick> counts = counts_in(first, in_brick.size());
    const std::size_t listed = list_slots(in_brick, counts, slots);
    for (std::size_t i = 0; i < listed; ++i) {
      // Nine of ten have the log-odds of the one before: unknown, or at a clamp.
      const std::uint32_t slot = slots[i];
      if (in_brick[slot] != l) {
        l = in_brick[slot];
        weight = updated_weight(l);
      }
      weigh_slot(static_cast<std::uint32_t>(first) + slot, counts[slot], l, weight, weighed);
    }
  }
}

/// True if nothing is, nor will be born, in a brick: of a large map most are empty.
bool Particles::is_empty(const RingBuffer<float>& map, std::size_t brick) const {
  const auto has_any = [brick](const Part& part) { return part.counted.in_slot.any_in(brick); };
  return !(map.range(brick).high > occupied_above_) &&
         std::none_of(parts_.begin(), parts_.end(), has_any);
}

/// Number of particles in each of n slots of a brick, after `predict`.
std::array<std::uint32_t, kBrick> Particles::counts_in(std::size_t first, std::size_t n) const {
  std::array<std::uint32_t, kBrick> sums{};
  for (const Part& part : parts_) {
    const std::uint32_t* const counts = &part.counted.in_slot.all()[first];
    for (std::size_t i = 0; i < n; ++i) sums[i] += counts[i];
  }
  return sums;
}

/// Into `slots`, those of a brick that hold particles, or in which some are to be born, counted
/// from its first; how many. Without a branch, as which of them do looks like chance.
std::size_t Particles::list_slots(std::span<const float> log_odds,
                                  const std::array<std::uint32_t, kBrick>& counts,
                                  std::array<std::uint32_t, kBrick>& slots) const {
  const auto has_births = static_cast<std::size_t>(min_per_voxel_ != 0);
  std::size_t n = 0;
  for (std::size_t slot = 0; slot < log_odds.size(); ++slot) {
    slots[n] = static_cast<std::uint32_t>(slot);
    const auto holds = static_cast<std::size_t>(counts[slot] != 0);
    const auto births = static_cast<std::size_t>(log_odds[slot] > occupied_above_) & has_births;
    n += holds | births;
  }
  return n;
}

void Particles::weigh_slot(std::uint32_t slot, std::uint32_t count, float l, std::uint32_t weight,
                           Weighed& weighed) const {
  weighed.total_weight += std::uint64_t{count} * weight;
  if (count < min_per_voxel_ && l > occupied_above_) {
    const auto voxel = static_cast<std::uint32_t>(weighed.voxels.size());
    const auto prior = static_cast<std::uint32_t>(kOneWeight * prior_weight_);
    const Weighed::Births births{voxel, min_per_voxel_ - count, weight - prior};
    weighed.births.push_back(births);
    weighed.total_weight += std::uint64_t{births.count} * births.weight;
  }
  weighed.voxels.push_back({slot, weight});
}

/// Lays the claims of all voxels end to end; in a voxel, those of part after part, then the births.
void Particles::claim() {
  const std::vector<Weighed::Voxel>& voxels = weighed().voxels;
  std::uint32_t most = 0;
  for (const Weighed::Voxel& voxel : voxels) most = std::max(most, voxel.weight);
  const double per_weight =
      static_cast<double>(n_init_) / static_cast<double>(weighed().total_weight);
  const auto most_claimed = static_cast<std::uint64_t>(most * per_weight);
  claimed_.bits = kClaimBits - static_cast<int>(std::bit_width(most_claimed));
  // Twice as much is even: the lowest bit is left to Claim::has_births.
  const double half_per_weight = std::ldexp(per_weight, claimed_.bits - 1);
  claimed_.each.resize(voxels.size());
  claimed_.births.clear();
  for (Part& part : parts_) {
    part.next.resize(voxels.size());
    part.next[0] = 0;
    part.before.assign(weighed().births.size(), VelocitySum{});
  }
  // From its first slot on, placed.
  const SparseNumbers::Writer closed = parts_[0].counted.in_slot.writer();
  const RandomStream stream(seed_, Purpose::kResampling, frame_);
  std::uint64_t next = stream.bits(0) >> (64 - claimed_.bits);
  auto births = weighed().births.begin();
  for (std::size_t i = 1; i < voxels.size(); ++i) {
    const auto [slot, weight] = voxels[i];
    const bool has_births = births != weighed().births.end() && births->voxel == i;
    const Claim each{2 * normalised(weight, half_per_weight) | (has_births ? 1U : 0U)};
    std::uint32_t count = 0;
    for (Part& part : parts_) {
      part.next[i] = next;
      count += part.counted.in_slot[slot];
      next += std::uint64_t{part.counted.in_slot[slot]} * each.size;
    }
    // Particles that still name a voxel with none are forgotten ones: they claim nothing.
    claimed_.each[i] = count == 0 ? Claim{} : each;
    if (has_births) {
      claimed_.births.push_back(2 * normalised(births->weight, half_per_weight));
      next += std::uint64_t{births->count} * claimed_.births.back();
      ++births;
    }
    closed.set(slot, static_cast<std::uint32_t>(i));
  }
  std::swap(placed_.in_slot, parts_[0].counted.in_slot);
}

void Particles::resample(const RingIndex& index) {
  claim();
  parallel_.for_each_part([this](int part) { resample_part(part); });
  place_newborn(index);
  particles_.swap(resampled_);
}

/// Block by block: where the copies of all go; the third copies and more at once, the first two
/// while the next block claims. In between their places come into the first cache: stores would
/// wait for them one after the other. Claiming waits for what it loads, copying for what it stores.
LDM_TARGET_CLONES void Particles::resample_part(int number) {
  Part& part = parts_[static_cast<std::size_t>(number)];
  const std::uint32_t* const voxel_in = placed_.in_slot.all().data();
  const Claim* const claims = claimed_.each.data();
  std::uint64_t* const next_of = part.next.data();
  auto* const resampled = reinterpret_cast<std::byte*>(resampled_.data());
  const int bits =
      claimed_.bits - CopyPlaces::kSizeBits;  // 1 or more: N_init < 2^26 (parameters.h)
  CopyPlaces copies(n_init_, n_init_ + kSpare * (1 + static_cast<std::size_t>(number)));
  const auto claim_places = [&](std::size_t i, const Particle& p) {
    const std::uint32_t voxel = voxel_in[p.slot];
    const Claim claim = claims[voxel];
    const std::uint64_t next = next_of[voxel];
    next_of[voxel] = next + claim.size;
    copies.claim(i, next >> bits, (next + claim.size) >> bits);
    __builtin_prefetch(resampled + (next >> bits), kToWrite);
    if (claim.has_births()) add_to_births(voxel, p, part);
  };
  const auto copy = [&](std::size_t i, const Particle& p) {
    const ParticleCopy particle(p);
    particle.put(resampled + copies.first(i));
    particle.put(resampled + copies.second(i));
  };
  std::span<const Particle> previous;
  const auto [begin, end] = stretch(number);
  for (std::size_t from = begin; from < end; from += CopyPlaces::kBlock) {
    const auto block = all().subspan(from, std::min(CopyPlaces::kBlock, end - from));
    const std::size_t both = std::min(block.size(), previous.size());
    for (std::size_t i = 0; i < both; ++i) {
      claim_places(i, block[i]);
      copy(i, previous[i]);
    }
    for (std::size_t i = both; i < block.size(); ++i) claim_places(i, block[i]);  // the first block
    for (std::size_t i = both; i < previous.size(); ++i) copy(i, previous[i]);    // the last
    // Behind the last of all, the places are those of a block before: at worst a needless third.
    const bool third = copies.choose();
    for (std::size_t i = 0; third && i < block.size(); ++i) {
      const ParticleCopy particle(block[i]);
      std::uint32_t to = copies.first(i) + 2 * CopyPlaces::kSize;
      for (; to < copies.end(i); to += CopyPlaces::kSize) particle.put(resampled + to);
    }
    previous = block;
  }
  for (std::size_t i = 0; i < previous.size(); ++i) copy(i, previous[i]);
}

/// `p` is one of those that were in a voxel before births. Few are, so this stays out of the loop.
[[gnu::noinline]] void Particles::add_to_births(std::uint32_t voxel, const Particle& p,
                                                Part& part) const {
  const std::vector<Weighed::Births>& all = weighed().births;
  const auto births = std::lower_bound(
      all.begin(), all.end(), voxel,
      [](const Weighed::Births& b, std::uint32_t number) { return b.voxel < number; });
  part.before[static_cast<std::size_t>(births - all.begin())].add(p);
}

/// The newborn of each voxel, behind the copies of those that were there.
void Particles::place_newborn(const RingIndex& index) {
  const RandomStream stream(seed_, Purpose::kBirth, frame_);
  const VoxelBox slots{Eigen::Vector3i::Zero(), index.window().size};
  for (std::size_t i = 0; i < weighed().births.size(); ++i) {
    const Weighed::Births& births = weighed().births[i];
    const std::uint32_t slot = weighed().voxels[births.voxel].slot;
    const Eigen::Vector3i corner = slots.voxel(slot) * (1 << fraction_bits_);
    std::uint64_t& next = parts_.back().next[births.voxel];
    VelocitySum before;
    for (const Part& part : parts_) before.add(part.before[i]);
    for (std::uint32_t birth = 0; birth < births.count; ++birth) {
      const std::uint64_t begin = next >> claimed_.bits;
      next += claimed_.births[i];
      const std::uint64_t end = std::min<std::uint64_t>(next >> claimed_.bits, n_init_);
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
