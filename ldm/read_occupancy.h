#pragma once
/// From log-odds in a ring buffer to probabilities in window order.
#include "ldm/ring_buffer.h"

namespace ldm {

/// Write window, resolution and P(Occ) of `log_odds` into `map`. Cost: one pass over the map.
void read_occupancy(const RingBuffer<float>& log_odds, double resolution, LocalMap& map);

}  // namespace ldm
