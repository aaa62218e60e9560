#pragma once
/// The text files beside a recorded log: what MRPT's format has no place for (paper Sec. 4.1.1;
/// docs/log-format.md).
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "datasets/files/csv.h"
#include "datasets/frame.h"
#include "datasets/quaternion_pose.h"
#include "datasets/scenario/lidar.h"

namespace datasets {

/// Names of the files that make up one log.
struct LogFiles {
  /// @throws ldm::InvalidInput unless the name ends in `.rawlog`.
  explicit LogFiles(const std::filesystem::path& rawlog);

  std::filesystem::path rawlog;       ///< NAME.rawlog
  std::filesystem::path description;  ///< NAME.log.toml
  std::filesystem::path frames;       ///< NAME.frames.csv
  std::filesystem::path truth;        ///< NAME.truth.csv
  std::filesystem::path solids;       ///< NAME.solids.csv
};

/// What holds for the whole log.
struct LogDescription {
  std::int64_t frames = 0;
  LidarModel lidar;
  ldm::Pose T_uav_sensor;
};

void write_description(const LogDescription& description, std::ostream& out);
/// @throws ldm::InvalidInput with file, line and key.
LogDescription read_description(const std::filesystem::path& file);

/// What holds for one frame.
struct FrameRow {
  std::int64_t frame = 0;
  double time = 0;  ///< [s]
  QuaternionPose T_world_uav;
};

/// Writes NAME.frames.csv, NAME.truth.csv and NAME.solids.csv.
class SidecarWriter {
 public:
  SidecarWriter(std::ostream& frames, std::ostream& truth, std::ostream& solids);
  void write(const FrameRow& row, const std::vector<ObjectState>& objects);

 private:
  CsvWriter frames_, truth_, solids_;
};

/// Reads the same, frame by frame. Errors are `ldm::InvalidInput` with file and line.
class SidecarReader {
 public:
  SidecarReader(const LogFiles& files, std::int64_t frames);
  /// Requires that fewer than `frames` frames were read.
  FrameRow read(std::vector<ObjectState>& objects);
  /// To be called after the last frame. @throws ldm::InvalidInput if a file holds more.
  void check_end();

 private:
  ObjectState read_object(std::int64_t frame);
  Solid read_solid(std::int64_t frame, std::int64_t id);

  std::int64_t count_, next_ = 0;
  CsvReader frames_, truth_, solids_;
};

}  // namespace datasets
