#pragma once
/// Occupancy update: measurement and survival: paper Sec. 3.3.2, Eq. (8)-(10).
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ldm/machine/lanes.h"
#include "ldm/machine/parallel.h"
#include "ldm/parameters.h"
#include "ldm/ring_buffer.h"

namespace ldm {

using LogOddsRange = Range<float>;

/// Log-odds of one measurement, by the flag of its voxel.  Eq. (9)
struct MeasurementLogOdds {
  float occupied;
  float free;
  explicit MeasurementLogOdds(const SensorModelParameters& p);
};

/// In which slots an object of k - 1 stands, and whether it is static: for eq. 10.
struct StaticVoxels {
  const SparseNumbers* owner = nullptr;  ///< 1 + number of the object, 0 for none; null: no object
  std::span<const std::uint8_t> is_static;  ///< per object: 1 or 0

  bool any_in(std::size_t brick) const { return owner != nullptr && owner->any_in(brick); }
  /// Requires an owner.
  bool at(std::size_t slot) const {
    const std::uint32_t number = (*owner)[slot];
    return number != 0 && is_static[number - 1] != 0;
  }
};

/// What one frame does to the log-odds of each voxel.
class OccupancyUpdate {
 public:
  /// Without `survival` a voxel that no ray met keeps its log-odds, as in Usenko et al.
  /// @param threads as of ExecutionParameters; the result does not depend on it
  OccupancyUpdate(const MapParameters& map, const SensorModelParameters& sensor,
                  const SurvivalParameters& survival, std::int64_t threads = 1);

  /// Adds the measurements to the voxels with a hit or a crossing ray and lets the others decay.
  /// `flags` in window order; static objects do not decay. Cost: the bricks (bricks.h) that change.
  void apply(std::span<const std::uint8_t> flags, const StaticVoxels& kept,
             RingBuffer<float>& log_odds) const;

  /// l_k = l_{k-1} + l(z), within the clamps.  Eq. (8)
  float measured(float l, float l_z) const { return clamps_.clamped(l + l_z); }
  /// l_k = l_{k-1} P_s; 0 once nothing is left, as denormal numbers slow every frame.  Eq. (10)
  static float survived(float l, float p_s) {
    const float rest = l * p_s;
    return rest * rest < 1e-12F ? 0 : rest;
  }
  /// P_s of a voxel that held no static object, by its flag: out of view, or in a shadow.
  float survival(std::uint8_t flag) const { return change_[flag].survival; }

 private:
  /// What a flag does to log-odds.
  struct Change {
    float survival;  // P_s; 1 for a measured voxel
    float gain;      // l(z); 0 for an unmeasured voxel
    bool is_none() const { return survival == 1 && gain == 0; }
  };
  struct Clamps {
    float min;
    float max;
    float clamped(float l) const { return std::clamp(l, min, max); }
    float changed(float l, Change by) const { return clamped(survived(l, by.survival) + by.gain); }
  };
  /// Voxels of a row that lie in one brick.
  struct Piece {
    const std::uint8_t* flags;
    const std::uint8_t* kept;  // 1 where a static object stands; or none
    float* l;
    std::size_t size;
  };
  class FourVoxels;
  void apply_to_rows(std::size_t begin, std::size_t end, std::span<const std::uint8_t> flags,
                     const StaticVoxels& kept, RingBuffer<float>& log_odds) const;
  bool stays(const Piece& piece, const LogOddsRange& range) const;
  void apply_to_piece(const Piece& piece, const LogOddsRange& before, FourVoxels& four) const;

  Clamps clamps_;
  std::array<Change, 256> change_;  // by flag
  Parallel parallel_;
};

}  // namespace ldm
