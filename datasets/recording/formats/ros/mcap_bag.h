#pragma once
/// Bags of ROS 2 in MCAP files (mcap.dev/spec; no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/formats/ros/bag_file.h"

namespace datasets {

/// @throws ldm::InvalidInput if it cannot be read or does not begin as an MCAP file.
std::unique_ptr<BagFile> open_mcap_bag(const std::filesystem::path& file);

}  // namespace datasets
