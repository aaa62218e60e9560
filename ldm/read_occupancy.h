#pragma once
/// From log-odds in a ring buffer to probabilities in window order.
#include "ldm/ring_buffer.h"

namespace ldm {

/// Write window, resolution and P(Occ) of `log_odds` into `map`. Cost: one pass over the map.
void read_occupancy(const RingBuffer<float>& log_odds, double resolution, LocalMap& map);

/// Set `points` of all clusters to the returns in their voxels of the scan that `map` was last
/// updated with; a hidden one has none. Apart from the update, as not everyone needs it. Cost: the
/// points.
void count_points(const Scan& scan, LocalMap& map);

}  // namespace ldm
