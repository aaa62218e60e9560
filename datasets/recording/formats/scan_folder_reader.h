#pragma once
/// A recording that has a file for each scan, with times and poses in text files beside (no paper
/// section).
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"
#include "datasets/recording/scans/scan_timeline.h"

namespace datasets {

/// What tells the formats apart.
struct ScanFolder {
  std::filesystem::path folder;
  std::vector<std::string> names;  ///< of the scans in it, in their order
  /// Reads the points of one file, in the order of the file; throws BrokenFrame.
  std::function<void(const std::filesystem::path&, std::vector<ldm::Point>&)> load;
  TimelineFiles timeline;
  /// Of the scans, where no trajectory has them; empty, or one for each.
  std::vector<std::optional<ldm::Pose>> poses;
  PosesOf poses_of = PosesOf::kSensor;       ///< whose poses they are if nobody says otherwise
  std::optional<ldm::Pose> T_sensor_camera;  ///< of the camera, if kCamera
  std::optional<ldm::Pose> T_uav_sensor;     ///< if the recording says it
};

class ScanFolderReader : public ScanReader {
 public:
  /// @throws ldm::InvalidInput if a file cannot be read, or has lines too few or too many, of which
  ///   nothing tells which.
  ScanFolderReader(ScanFolder folder, const RecordingOptions& options);

  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override {
    return static_cast<std::int64_t>(folder_.names.size());
  }
  std::string place() const override { return timeline_.place(); }

 private:
  /// Of a pose of the trajectory: the sensor's or the vehicle's.
  ldm::Pose sensor_or_vehicle(const ldm::Pose& pose) const;

  ScanFolder folder_;
  ldm::Pose T_uav_sensor_;
  PosesOf poses_of_;
  ScanTimeline timeline_;
  std::int64_t next_ = 0;  // line
  std::size_t scans_ = 0;  // that are there, in the lines before
};

/// What the options name, else these, which need not be there.
/// @throws ldm::InvalidInput if poses are needed and missing.
TimelineFiles timeline_files(const std::filesystem::path& times, const std::filesystem::path& poses,
                             const RecordingOptions& options);

/// The bytes of a scan file.
/// @throws BrokenFrame if it is missing, cannot be read, or is larger than 2 GB.
void read_scan_file(const std::filesystem::path& file, std::string& content);

}  // namespace datasets
