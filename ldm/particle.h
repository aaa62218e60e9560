#pragma once
/// A particle and the sum of some: paper Eq. (2), (3), (12).
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "ldm/lanes.h"
#include "ldm/types.h"

namespace ldm {

/// A particle in 16 bytes. Positions are fixed-point voxel coordinates modulo the map, like the
/// slots of the ring buffer: the voxel is the integer part, so a moving map moves no particle.
struct Particle {
  std::uint16_t x, y, z;    ///< position [voxels / 2^fraction bits].  Eq. (2)
  std::int16_t vx, vy, vz;  ///< velocity [kVelocityQuantum]; saturates at +-32 m/s.  Eq. (3)
  std::uint32_t slot;       ///< of its voxel; the number of voxels once it has left the map

  static constexpr double kVelocityQuantum = 1.0 / 1024;  ///< [m/s]
};

/// A particle's three axes side by side: x, y, z in lanes 0 to 2; what is in lane 3 means nothing.
///
/// Eight bytes from x or from vx on are one load, and the same bytes one store: arithmetic on three
/// axes at once makes `Particles::predict` 1.7 times faster than on one after the other.
struct ParticleLanes {
  Lanes position;
  Lanes velocity;

  explicit ParticleLanes(const Particle& p)
      : position(__builtin_convertvector(load<Positions>(p, kX), Lanes)),
        velocity(__builtin_convertvector(load<Velocities>(p, kVx), Lanes)) {}

  /// Into `p`, whose slot is `slot` from now on. Positions and velocities fit 16 bits.
  void store(std::uint32_t slot, Particle& p) const {
    const auto x = __builtin_convertvector(position, Positions);
    const auto v = __builtin_convertvector(velocity, Velocities);
    // Each also writes two bytes of what comes next, which is therefore written next.
    std::memcpy(bytes(p) + kX, &x, sizeof x);
    std::memcpy(bytes(p) + kVx, &v, sizeof v);
    p.slot = slot;
  }

 private:
  using Positions = std::uint16_t __attribute__((vector_size(8)));
  using Velocities = std::int16_t __attribute__((vector_size(8)));
  static constexpr std::size_t kX = offsetof(Particle, x);
  static constexpr std::size_t kVx = offsetof(Particle, vx);
  static_assert(sizeof(Particle) == 16 && kVx + sizeof(Velocities) <= sizeof(Particle));

  static std::byte* bytes(Particle& p) { return reinterpret_cast<std::byte*>(&p); }

  template <class Half>
  static Half load(const Particle& p, std::size_t offset) {
    Half half;
    std::memcpy(&half, reinterpret_cast<const std::byte*>(&p) + offset, sizeof half);
    return half;
  }
};

/// Sum of the velocities of some particles, in Particle::kVelocityQuantum: exact in any order.
struct VelocitySum {
  std::int64_t x = 0, y = 0, z = 0;
  std::int64_t particles = 0;

  void add(const Particle& p) {
    x += p.vx;
    y += p.vy;
    z += p.vz;
    ++particles;
  }
  void add(const VelocitySum& other) {
    x += other.x;
    y += other.y;
    z += other.z;
    particles += other.particles;
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
