#pragma once
/// Scans of little-endian floats, as KITTI and nuScenes have them (no paper section).
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/recording/scans/input_parameters.h"
#include "ldm/types.h"

namespace datasets {

inline constexpr std::string_view kBinEnding = ".bin";

/// Reads the points of one file after the other; the first one tells how many floats a point has.
/// Throws BrokenFrame, or ldm::InvalidInput if nothing tells.
std::function<void(const std::filesystem::path&, std::vector<ldm::Point>&)> bin_loader(
    BinColumns columns);

/// Floats of each point, of which the first three are x, y, z; appends to `points` [m].
/// @param name for messages
/// @param columns floats of each point
/// @throws BrokenFrame if the file is empty or ends in the middle of a point.
void parse_bin_scan(const std::string& content, const std::string& name, std::size_t columns,
                    std::vector<ldm::Point>& points);

}  // namespace datasets
