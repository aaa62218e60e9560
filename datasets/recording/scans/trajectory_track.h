#pragma once
/// A trajectory file as poses at any time (no paper section).
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "datasets/recording/scans/time_unit.h"
#include "datasets/recording/scans/trajectory.h"

namespace datasets {

/// Poses of a file with times, read as far as they are asked for.
class TrajectoryTrack {
 public:
  /// @param file with times
  /// @param unit of them [s]
  TrajectoryTrack(TrajectoryFile file, double unit) : file_(std::move(file)), unit_(unit) {}

  /// As `PoseTrack::at`. @throws BrokenFrame naming the line that is broken.
  std::optional<ldm::Pose> at(double time, double longest_gap);
  /// For messages: the times of the poses around.
  std::string around(double time) const { return track_.around(time); }

 private:
  TrajectoryFile file_;
  double unit_;
  PoseTrack track_;
};

/// @param words of a line, of which the first is a time
/// @throws ldm::InvalidInput if the times look like another unit than seconds.
void check_seconds(const std::filesystem::path& file, std::size_t words);

}  // namespace datasets
