#pragma once
/// Random numbers without a running state: each draw is a hash of what it is for.
///
/// Particle i of frame k gets the same numbers whichever thread asks, and in whichever order, so
/// results do not depend on the number of threads.
#include <cstdint>

namespace ldm {

/// What a draw is for: draws of different purposes are independent.
enum class Purpose : std::uint64_t { kInitial, kPrediction, kBirth, kResampling };

/// The stream of (seed, purpose, frame): `bits(i)` is its i-th 64-bit number.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, Purpose purpose, std::uint64_t frame)
      : key_(mix(mix(seed ^ kA, kB) + static_cast<std::uint64_t>(purpose), frame ^ kC)) {}

  std::uint64_t bits(std::uint64_t i) const { return mix(mix(i ^ key_, kA) ^ kC, key_ ^ kB); }

 private:
  // The folded product of wyhash (W. Yi, public domain): one 64 x 64 -> 128 bit multiplication.
  static std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = Wide{a} * b;
    return static_cast<std::uint64_t>(product ^ (product >> 64));
  }
  static constexpr std::uint64_t kA = 0xa0761d6478bd642fULL;
  static constexpr std::uint64_t kB = 0xe7037ed1a0b428dbULL;
  static constexpr std::uint64_t kC = 0x8ebc6af09c88c6e3ULL;

  std::uint64_t key_;
};

}  // namespace ldm
