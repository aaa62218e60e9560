#pragma once
/// The trajectory that `--poses` or a folder of scans names: a file, or a folder of another program
/// (no paper section).
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "datasets/recording/scans/time_unit.h"
#include "datasets/recording/scans/trajectory.h"

namespace datasets {

/// What of a path holds the poses: a file or KITTI's `oxts` itself; of a folder with results of
/// KISS-ICP, or that of its runs with `latest` in it, NAME_poses_kitti.txt, which has all digits,
/// or NAME_poses_tum.txt.
/// @throws ldm::InvalidInput if there is none in a folder, or more than one.
std::filesystem::path trajectory_in(const std::filesystem::path& path);

/// @param path as `trajectory_in` gives it
/// @param unit of its times; absent: seconds, checked
/// @throws ldm::InvalidInput if it cannot be read, is none, or has times of another unit.
std::unique_ptr<PoseSequence> open_trajectory(const std::filesystem::path& path,
                                              std::optional<TimeUnit> unit);

/// True if line k is the pose of scan k: lines without times, and those whose times are 0, 1, 2,
/// ... if there are `scans` of them or the file is KISS-ICP's, which counts scans where it knows no
/// times.
/// @param scans 0: not known
bool counts_scans(const std::filesystem::path& path, std::int64_t scans);

}  // namespace datasets
