#pragma once
/// What a mapper answered, checked before anything is made of it (no paper section).
#include <cstdint>
#include <string_view>

#include "ldm/types.h"

namespace experiments {

/// A plugin may hand over anything, and a fault of ours should not become a score. Cost: one pass
/// over the map, 3 us for 32^3 voxels.
/// @throws std::runtime_error naming method, frame, field, value and what is allowed, unless the
/// window has 1 to 4096 voxels along each axis, all arrays have its length, occupancy lies in
/// [0, 1], labels are -1 or positions in `clusters`, and clusters hold finite numbers, sizes and
/// counts of 0 or more.
void check_map(const ldm::LocalMap& map, std::string_view method, std::int64_t frame);

}  // namespace experiments
