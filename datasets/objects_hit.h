#pragma once
/// Which object each ray of a scan met (no paper section).
#include <cstdint>
#include <vector>

#include "datasets/frame.h"

namespace datasets {

/// For each of `truth.noise_free_hits` of a scan from `sensor` (world [m]) the position in
/// `truth.objects` of the first object that it is on, or -1.
std::vector<std::int32_t> objects_hit(const Truth& truth, const Eigen::Vector3d& sensor);

}  // namespace datasets
