#pragma once
/// What the particle filter knows of the voxels from pass to pass, one type a phase, and where the
/// copies of particles go: for paper Sec. 3.3.3 and 3.4.
///
/// `Particles::predict` counts, `weigh` weighs; in `resample` all particles claim parts of the next
/// generation, whose members are then placed voxel by voxel.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ldm/machine/bricks.h"
#include "ldm/particle.h"

namespace ldm {

/// How many particles are in each slot, and in one more all that left the map.
struct Counted {
  SparseNumbers in_slot;
};

/// The voxels that hold particles, or in which some are to be born, in slot order.
struct Weighed {
  struct Voxel {
    std::uint32_t slot;
    std::uint32_t weight;  // of each particle there [2^-24]
  };
  struct Births {
    std::uint32_t voxel;  // number among `voxels`
    std::uint32_t count;
    std::uint32_t weight;  // of each [2^-24]
  };
  std::vector<Voxel> voxels;  // the first of all is nobody's
  std::vector<Births> births;
  std::uint64_t total_weight = 0;

  void reserve(std::size_t most_voxels, std::size_t usual_births) {
    voxels.reserve(most_voxels);
    births.reserve(usual_births);
  }
  void clear() {
    voxels.clear();
    births.clear();
    total_weight = 0;
  }
  void append(const Weighed& behind) {
    const auto before = static_cast<std::uint32_t>(voxels.size());
    voxels.insert(voxels.end(), behind.voxels.begin(), behind.voxels.end());
    for (const Births& b : behind.births) births.push_back({before + b.voxel, b.count, b.weight});
    total_weight += behind.total_weight;
  }
};

/// What a particle claims of the next generation [2^-Claimed::bits particles]: an odd number where
/// more are to be born beside it, else an even one.
struct Claim {
  std::uint32_t size = 0;
  bool has_births() const { return size % 2 != 0; }
};

/// The comb of systematic resampling runs through the claims of all particles, voxel by voxel.
struct Claimed {
  int bits = 0;
  std::vector<Claim> each;            // beside Weighed::voxels: of each particle there
  std::vector<std::uint32_t> births;  // beside Weighed::births: of each newborn
};

/// In which voxel the particles of a slot are from now on. In the memory of Counted, whose phase is
/// over.
struct Placed {
  SparseNumbers in_slot;  // number of its voxel among Weighed::voxels; 0 for none
};

/// A block of particles, and the places of their copies, in bytes: a shift makes one of a claim,
/// without a product. Claims end within places; the lowest four bits, which say where, are cut off.
///
/// Most have no copy, one or two, as if by chance: a processor that guesses which loses more time
/// than by two copies of all, which go to a spare place where they are too many. The choice is made
/// in vectors.
class CopyPlaces {
 public:
  static constexpr std::size_t kBlock = 64;
  static constexpr std::uint32_t kSize = sizeof(Particle);
  static constexpr int kSizeBits = std::countr_zero(kSize);

  /// @param places for copies: what is claimed beyond them is lost; fewer than 2^28
  /// @param spare number of a place beyond them, below 2^28
  CopyPlaces(std::size_t places, std::size_t spare)
      : end_(static_cast<std::uint32_t>(places) * kSize),
        spare_(static_cast<std::uint32_t>(spare) * kSize) {}

  /// Particle i of the block claims [begin, end) of the places. `first` and `second` still are
  /// those of the block before.
  void claim(std::size_t i, std::uint64_t begin, std::uint64_t end) {
    begin_[i] = static_cast<std::uint32_t>(begin);
    claimed_to_[i] = static_cast<std::uint32_t>(end);
  }
  /// For all of a block, after `claim`. True if one of its particles has a third copy.
  bool choose() {
    std::uint32_t any = 0;
    for (std::size_t i = 0; i < kBlock; ++i) {
      const std::uint32_t begin = std::min(place(begin_[i]), end_);
      const std::uint32_t bytes = end(i) - begin;
      first_[i] = bytes > 0 ? begin : spare_;
      second_[i] = bytes > kSize ? begin + kSize : spare_;
      any |= static_cast<std::uint32_t>(bytes > 2 * kSize);
    }
    return any != 0;
  }
  /// Of the first two copies, or the spare place.
  std::uint32_t first(std::size_t i) const { return first_[i]; }
  std::uint32_t second(std::size_t i) const { return second_[i]; }
  /// Behind the last copy.
  std::uint32_t end(std::size_t i) const { return std::min(place(claimed_to_[i]), end_); }

 private:
  static std::uint32_t place(std::uint32_t in_it) { return in_it & ~(kSize - 1); }

  std::uint32_t end_, spare_;
  std::array<std::uint32_t, kBlock> begin_{}, claimed_to_{};
  std::array<std::uint32_t, kBlock> first_{}, second_{};
};

}  // namespace ldm
