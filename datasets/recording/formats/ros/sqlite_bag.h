#pragma once
/// Bags of ROS 2 in SQLite files, *.db3 (rosbag2_storage_sqlite3; no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/formats/ros/bag_file.h"

namespace datasets {

/// Messages come in the order of their times.
/// @throws ldm::InvalidInput if it cannot be read or has not the tables `topics` and `messages`.
std::unique_ptr<BagFile> open_sqlite_bag(const std::filesystem::path& file);

}  // namespace datasets
