#pragma once
/// A recording that has a file for each scan, with times and poses in text files beside (no paper
/// section).
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"
#include "datasets/recording/scans/scan_timeline.h"

namespace datasets {

/// What tells the formats apart.
struct ScanFolder {
  std::int64_t scans = 0;  ///< number of scan files, or the number after that of the last
  std::function<std::filesystem::path(std::int64_t)> file_of;
  /// Reads the points of one file, in the order of the file; throws BrokenFrame.
  std::function<void(const std::filesystem::path&, std::vector<ldm::Point>&)> load;
  TimelineFiles timeline;
  ldm::Pose T_sensor_camera;  ///< the poses are those of a camera that sits here
  PosesOf poses_of = PosesOf::kSensor;
};

class ScanFolderReader : public ScanReader {
 public:
  /// @param complete files that do not fit together are refused at once, not frame by frame
  /// @throws ldm::InvalidInput if a file cannot be read or, if `complete`, has lines too few or
  ///   too many.
  ScanFolderReader(ScanFolder folder, const InputParameters& parameters, bool complete);

  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override { return frames_; }
  std::string place() const override { return timeline_.place(); }

 private:
  ScanFolder folder_;
  ldm::Pose T_uav_sensor_;
  ScanTimeline timeline_;
  std::int64_t frames_;
  std::int64_t next_ = 0;
};

/// FOLDER/poses.txt and FOLDER/times.txt, or what the options name instead.
/// @throws ldm::InvalidInput if poses are needed and missing.
TimelineFiles timeline_files(const std::filesystem::path& folder, const RecordingOptions& options);

/// The bytes of a scan file.
/// @throws BrokenFrame if it is missing, cannot be read, or is larger than 2 GB.
void read_scan_file(const std::filesystem::path& file, std::string& content);

}  // namespace datasets
