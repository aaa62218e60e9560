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

/// Log-odds of one measurement, by the flag of its voxel.  Eq. (9)
struct MeasurementLogOdds {
  float occupied;
  float free;
  explicit MeasurementLogOdds(const SensorModelParameters& p);
};

/// What one frame does to the log-odds of each voxel.
class OccupancyUpdate {
 public:
  /// Without `survival` a voxel that no ray met keeps its log-odds, as in Usenko et al.
  /// @param threads as of ExecutionParameters; the result does not depend on it
  OccupancyUpdate(const MapParameters& map, const SensorModelParameters& sensor,
                  const SurvivalParameters& survival, std::int64_t threads = 1);

  /// Adds the measurements to the voxels with a hit or a crossing ray and lets the others decay.
  /// `flags` in window order; `log_odds` and `kept` in slots. `kept` is 1 where a static object
  /// stood at k - 1, empty if nothing is static.
  void apply(std::span<const std::uint8_t> flags, std::span<const std::uint8_t> kept,
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
  void apply_to_layers(int begin, int end, std::span<const std::uint8_t> flags,
                       std::span<const std::uint8_t> kept, RingBuffer<float>& log_odds) const;
  void apply_to_row(int n, const std::uint8_t* flags, const std::uint8_t* kept, float* l) const;
  void apply_to_each(int begin, int end, const std::uint8_t* flags, const std::uint8_t* kept,
                     float* l) const;
  void change_stretch(Change change, float* l) const;
  void change_stretch(UInt8x16 flags, float* l) const;
  std::int64_t bytes_of(std::uint8_t flag) const;

  Clamps clamps_;
  std::array<Change, 256> change_;  // by flag
  Parallel parallel_;
};

}  // namespace ldm
