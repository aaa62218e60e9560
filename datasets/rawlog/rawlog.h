#pragma once
/// Recorded logs in MRPT's format, with the truth beside them (paper Sec. 4.1.1;
/// docs/log-format.md).
#include <filesystem>
#include <memory>

#include "datasets/frame.h"
#include "datasets/quaternion_pose.h"
#include "datasets/scenario/lidar.h"

namespace datasets {

/// Writes one log. Its files appear under their names when all of them are complete, at `close`;
/// a log that is not closed leaves nothing.
class RawlogWriter {
 public:
  /// @param rawlog NAME.rawlog; NAME.log.toml, NAME.frames.csv, NAME.truth.csv and
  ///   NAME.solids.csv come to stand beside it. Older files of these names are replaced.
  /// @throws ldm::InvalidInput if the name has another ending or the folder cannot be written.
  RawlogWriter(const std::filesystem::path& rawlog, const LidarModel& lidar,
               const ldm::Pose& T_uav_sensor);
  ~RawlogWriter();

  /// The next frame. `image` is as large as the LidarModel says; `time` [s] does not go back.
  /// @throws std::runtime_error if something could not be written.
  void write(double time, const QuaternionPose& T_world_uav, const RangeImage& image,
             const Truth& truth);
  /// To be called once, after the last frame.
  /// @throws std::runtime_error if something could not be written.
  void close();

 private:
  class Log;
  std::unique_ptr<Log> log_;
};

/// Reads such a log: the frames have the same bits as those written. Memory holds one frame.
class RawlogReader : public FrameSource {
 public:
  /// @throws ldm::InvalidInput if a file of the log is missing or its beginning is broken.
  explicit RawlogReader(const std::filesystem::path& rawlog);
  ~RawlogReader() override;

  const LidarModel& lidar() const;
  const ldm::Pose& T_uav_sensor() const;
  /// Damage that leaves every number plausible is found by the checksum at the end of the log,
  /// with the last frame: a broken log never reads to its end.
  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override;

 private:
  class Log;
  std::unique_ptr<Log> log_;
};

}  // namespace datasets
