#pragma once
/// The packets of a Velodyne or Ouster sensor as a recording (no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// True for *.pcap and *.pcapng.
bool is_pcap(const std::filesystem::path& file);

/// A turn of the sensor after the other, at the time when its first packet was captured; poses are
/// those of `options.poses`. Packets of a second sensor are counted.
/// @throws ldm::InvalidInput if the file cannot be read, holds no packets of a known sensor, or
///   poses are missing.
std::unique_ptr<ScanReader> open_pcap(const std::filesystem::path& file,
                                      const RecordingOptions& options);

}  // namespace datasets
