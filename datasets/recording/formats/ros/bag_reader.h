#pragma once
/// Bags of ROS as recordings (no paper section; docs/recordings.md).
#include <filesystem>
#include <memory>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// Scans and poses as `plan_of` chooses them; with input.deskew, points that say when they were
/// measured are moved to the time of their scan's stamp.
/// @throws ldm::InvalidInput if the bag cannot be read or leaves a choice.
std::unique_ptr<ScanReader> open_bag_recording(const std::filesystem::path& path,
                                               const RecordingOptions& options);

}  // namespace datasets
