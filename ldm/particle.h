#pragma once
/// A particle, and sums of velocities: paper Eq. (2), (3), (12).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "ldm/machine/lanes.h"
#include "ldm/types.h"

namespace ldm {

/// A particle in 16 bytes. Positions are fixed-point voxel coordinates modulo the map, like the
/// slots of the ring buffer: the voxel is the integer part, so a moving map moves no particle.
struct Particle {
  std::uint16_t x, y, z;    ///< position [voxels / 2^fraction bits].  Eq. (2)
  std::int16_t vx, vy, vz;  ///< velocity [kVelocityQuantum]; saturates at +-32 m/s.  Eq. (3)
  std::uint32_t slot;       ///< of its voxel; the number of voxels once it has left the map

  static constexpr double kVelocityQuantum = 1.0 / 1024;  ///< [m/s]

  /// A component of a velocity [m/s] in kVelocityQuantum.
  static std::int16_t quantised(float v) {
    const float units = v / static_cast<float>(kVelocityQuantum);
    return static_cast<std::int16_t>(std::lround(std::clamp(units, -32768.0F, 32767.0F)));
  }
};

/// Where vx is in a particle [bytes].
inline constexpr std::size_t kVelocityOffset = offsetof(Particle, vx);
/// Three axes, and two bytes more, in one access to the memory.
inline constexpr std::size_t kThreeAxes = 8;
static_assert(sizeof(Particle) == 16 && kVelocityOffset + kThreeAxes <= sizeof(Particle));

/// Two neighbouring particles: x, y, z of the first in lanes 0 to 2, of the second in 4 to 6; what
/// is in lanes 3 and 7 means nothing.
///
/// Eight bytes from x or from vx on are one load, and the same bytes one store; arithmetic is on
/// six numbers at once, none wider than it must be.
struct ParticlePair {
  UInt16x8 position;  ///< as Particle::x
  Int16x8 velocity;   ///< as Particle::vx

  explicit ParticlePair(const Particle* pair)
      : position(reinterpret_cast<UInt16x8>(load(pair, offsetof(Particle, x)))),
        velocity(velocity_of(pair)) {}

  /// Into pair[0] and pair[1], which are in `slots[0]` and `slots[2]` from now on.
  void store(const Int32x4& slots, Particle* pair) const {
    // Each also writes two bytes of what comes next, which is therefore written next.
    store(reinterpret_cast<Int64x2>(position), offsetof(Particle, x), pair);
    store(reinterpret_cast<Int64x2>(velocity), kVelocityOffset, pair);
    pair[0].slot = static_cast<std::uint32_t>(slots[0]);
    pair[1].slot = static_cast<std::uint32_t>(slots[2]);
  }

  /// vx, vy, vz of the sum of both velocities [Particle::kVelocityQuantum].
  static Int32x4 velocity_sum(const Particle* pair) {
    const Int16x8 v = velocity_of(pair);
    constexpr Int16x8 kOnes{1, 1, 1, 1, 1, 1, 1, 1};
    return sum_of_products(__builtin_shufflevector(v, v, 0, 4, 1, 5, 2, 6, 3, 7), kOnes);
  }

 private:
  static Int16x8 velocity_of(const Particle* pair) {
    return reinterpret_cast<Int16x8>(load(pair, kVelocityOffset));
  }
  static Int64x2 load(const Particle* pair, std::size_t offset) {
    Int64x2 words{};
    for (int i = 0; i < 2; ++i) {
      std::int64_t bytes = 0;
      std::memcpy(&bytes, reinterpret_cast<const std::byte*>(pair + i) + offset, kThreeAxes);
      words[i] = bytes;
    }
    return words;
  }
  static void store(const Int64x2& words, std::size_t offset, Particle* pair) {
    for (int i = 0; i < 2; ++i) {
      const std::int64_t bytes = words[i];
      std::memcpy(reinterpret_cast<std::byte*>(pair + i) + offset, &bytes, kThreeAxes);
    }
  }
};

/// A particle in one register, to be put down several times.
class ParticleCopy {
 public:
  explicit ParticleCopy(const Particle& p) { std::memcpy(&all_, &p, sizeof all_); }
  void put(std::byte* to) const { std::memcpy(to, &all_, sizeof all_); }

 private:
  Int32x4 all_;
};

/// One velocity for many particles: a load and a store each, instead of three stores.
class CommonVelocity {
 public:
  /// @param v [m/s]; saturates as in a particle
  explicit CommonVelocity(const Velocity& v)
      : velocity_(bytes_of({0, 0, 0, Particle::quantised(v.x()), Particle::quantised(v.y()),
                            Particle::quantised(v.z()), 0})),
        rest_(~bytes_of({0, 0, 0, -1, -1, -1, 0})) {}

  /// Positions and slots stay.
  void give(std::span<Particle> particles) const {
    for (Particle& p : particles) {
      const std::int64_t bytes = (bytes_of(p) & rest_) | velocity_;
      std::memcpy(reinterpret_cast<std::byte*>(&p) + kVelocityOffset, &bytes, kThreeAxes);
    }
  }

 private:
  static std::int64_t bytes_of(const Particle& p) {
    std::int64_t bytes = 0;
    std::memcpy(&bytes, reinterpret_cast<const std::byte*>(&p) + kVelocityOffset, kThreeAxes);
    return bytes;
  }
  std::int64_t velocity_, rest_;
};

/// Sum of the velocities of particles, in Particle::kVelocityQuantum: exact in any order.
struct VelocitySum {
  std::int64_t x = 0, y = 0, z = 0;
  std::int64_t particles = 0;

  void add(const Particle& p) {
    x += p.vx;
    y += p.vy;
    z += p.vz;
    ++particles;
  }
  /// In pairs, all axes at once. A lane holds the sum of 2^16 velocities.
  void add(std::span<const Particle> left) {
    constexpr std::size_t kMost = 1 << 16;
    while (left.size() > 1) {
      const std::size_t in_pairs = std::min(kMost, left.size()) / 2 * 2;
      Int32x4 sum{};
      for (std::size_t i = 0; i < in_pairs; i += 2) sum += ParticlePair::velocity_sum(&left[i]);
      x += sum[0];
      y += sum[1];
      z += sum[2];
      particles += static_cast<std::int64_t>(in_pairs);
      left = left.subspan(in_pairs);
    }
    if (!left.empty()) add(left[0]);
  }
  void add(const VelocitySum& sum) {
    x += sum.x;
    y += sum.y;
    z += sum.z;
    particles += sum.particles;
  }
  /// The mean [m/s]; zero if there are no particles. All weights are equal: eq. 12 and 16.
  Velocity mean() const {
    if (particles == 0) return Velocity::Zero();
    const double unit = Particle::kVelocityQuantum / static_cast<double>(particles);
    return Eigen::Vector3d(static_cast<double>(x) * unit, static_cast<double>(y) * unit,
                           static_cast<double>(z) * unit)
        .cast<float>();
  }
};

}  // namespace ldm
