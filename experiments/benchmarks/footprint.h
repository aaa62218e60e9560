#pragma once
/// What a map takes from the heap: in all, and once it has settled (no paper section).
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "ldm/mapper.h"
#include "ldm/parameters.h"

namespace benchmarks {

struct Footprint {
  std::int64_t peak_bytes = 0;  ///< most at one time, from making the map to the end of the warm-up
  std::int64_t update_blocks = 0;  ///< blocks taken by all updates after the warm-up
  std::int64_t read_blocks = 0;    ///< and by readings of the map into the same LocalMap

  /// Of a Local Dynamic Map, per voxel. The particle state is the particles of the last frame and
  /// those of the next, 16 bytes each.
  double bytes_beside_particles_per_voxel(const ldm::Parameters& parameters) const;
};

/// A map goes through all scans, of which the first `warm_up` let it settle.
Footprint footprint(const std::function<std::unique_ptr<ldm::Mapper>()>& make,
                    std::span<const ldm::Scan> scans, std::size_t warm_up);

}  // namespace benchmarks
