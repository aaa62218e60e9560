#pragma once
/// Recordings as a folder of PCD files (no paper section).
#include <filesystem>
#include <memory>
#include <string_view>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

inline constexpr std::string_view kPcdEnding = ".pcd";

/// FOLDER/*.pcd, in the natural order of their names (2.pcd before 10.pcd), with a trajectory in
/// FOLDER/poses.txt: TUM's, interpolated at the times of FOLDER/times.txt or with a line a scan, or
/// KITTI's with a line a scan and times.txt.
/// @throws ldm::InvalidInput naming the file that is missing, cannot be read, or has lines too few.
std::unique_ptr<ScanReader> open_pcd_folder(const std::filesystem::path& folder,
                                            const RecordingOptions& options);

}  // namespace datasets
