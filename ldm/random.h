#pragma once
/// Random numbers without a running state: each draw is a hash of what it is for.
///
/// Particle i of frame k gets the same numbers whichever thread asks, and in whichever order, so
/// results do not depend on the number of threads.
#include <array>
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
    return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
  }
  static constexpr std::uint64_t kA = 0xa0761d6478bd642fULL;
  static constexpr std::uint64_t kB = 0xe7037ed1a0b428dbULL;
  static constexpr std::uint64_t kC = 0x8ebc6af09c88c6e3ULL;

  std::uint64_t key_;
};

/// N(0, sigma^2) in whole units, by the inverse distribution function at 4096 equally likely
/// points.
///
/// 12 random bits make one draw: no logarithm, no sine, the same integers on every machine. The
/// points reach +-3.7 sigma; the table is scaled so that its variance is sigma^2 but for rounding.
class NormalTable {
 public:
  static constexpr int kBits = 12;

  /// @param sigma standard deviation in units; entries must fit 16 bits: 0 <= sigma <= 8000.
  explicit NormalTable(double sigma);

  /// A draw from the lowest 12 bits of `bits`.
  std::int16_t operator()(std::uint64_t bits) const { return values_[bits & (kSize - 1)]; }

 private:
  static constexpr std::size_t kSize = std::size_t{1} << kBits;
  std::array<std::int16_t, kSize> values_;
};

}  // namespace ldm
