#pragma once
/// A trajectory as poses at any time (no paper section).
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "datasets/recording/scans/time_unit.h"
#include "datasets/recording/scans/trajectory.h"

namespace datasets {

/// Poses with times, read as far as they are asked for.
class TrajectoryTrack {
 public:
  explicit TrajectoryTrack(std::unique_ptr<PoseSequence> poses) : poses_(std::move(poses)) {}

  /// As `PoseTrack::at`. @throws BrokenFrame naming the line that is broken.
  std::optional<ldm::Pose> at(double time, double longest_gap);
  /// For messages: the times of the poses around.
  std::string around(double time) const { return track_.around(time); }

 private:
  std::unique_ptr<PoseSequence> poses_;
  PoseTrack track_;
};

/// @param words of a line, of which the first is a time
/// @throws ldm::InvalidInput if the times look like another unit than seconds.
void check_seconds(const std::filesystem::path& file, std::size_t words);

}  // namespace datasets
