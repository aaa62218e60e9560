#pragma once
/// Bags of ROS 1, format 2.0 (wiki.ros.org/Bags/Format/2.0; no paper section). A decoder of our
/// own: Debian's librosbag-storage-dev brings 37 packages for these records.
#include <filesystem>
#include <memory>

#include "datasets/recording/formats/ros/bag_file.h"

namespace datasets {

/// @throws ldm::InvalidInput if it cannot be read or does not begin as a bag.
std::unique_ptr<BagFile> open_ros1_bag(const std::filesystem::path& file);

}  // namespace datasets
