#pragma once
/// A folder of .bin scans, as nuScenes has them (Caesar et al., CVPR 2020; no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// FOLDER/*.bin with FOLDER/times.txt or, without it, at the times that their names are: the number
/// at the end of each, in us (16 digits) or ns (19 digits). Poses in FOLDER/poses.txt
/// or, without it, in nuScenes' tables, as `nuscenes_tables` finds them.
/// @throws ldm::InvalidInput naming the file that is missing, cannot be read, or has lines too few.
std::unique_ptr<ScanReader> open_bin_folder(const std::filesystem::path& folder,
                                            const RecordingOptions& options);

}  // namespace datasets
