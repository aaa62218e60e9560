#pragma once
/// What is in a recording, in lines for a reader (no paper section; docs/recordings.md).
#include <filesystem>
#include <ostream>

#include "datasets/recording/scans/recording_options.h"

namespace datasets {

/// Of a bag: topics with type, number and rate of messages, times, frames, and what of it is
/// taken, or why nothing is; of packets of a network, their ways. Of any other recording: its
/// scans, their times and rate, points, and what was left out. Reads all of it.
/// @throws ldm::InvalidInput if it is none, or cannot be opened.
void describe_recording(const std::filesystem::path& path, const RecordingOptions& options,
                        std::ostream& out);

}  // namespace datasets
