#pragma once
/// The interface every compared method answers: a scan in, the local map out.
#include <string_view>

#include "ldm/types.h"

namespace ldm {

/// Told by a mapper when a stage of its update begins; the caller owns the clock.
class StageListener {
 public:
  virtual ~StageListener() = default;
  /// `stage` names what runs from now on (static storage), for instance "occupancy_update".
  virtual void begin(std::string_view stage) = 0;
};

class Mapper {
 public:
  virtual ~Mapper() = default;

  /// Take one scan. An empty scan is valid: it moves the map and ages it. A UAV that jumps by more
  /// than the map finds a fresh map. `listener` may be null.
  /// @throws InvalidInput on a point, pose or time that is not finite or beyond +-1e7 m, a rotation
  /// that is none, and time going backwards (see scan_check.h); the map is then as it was before.
  virtual void update(const Scan& scan, StageListener* listener = nullptr) = 0;

  /// Write the map after the last update; reuses the memory of `map`. Cost: one pass over the map.
  virtual void read(LocalMap& map) const = 0;
};

}  // namespace ldm
