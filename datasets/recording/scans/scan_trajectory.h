#pragma once
/// Where the sensor was when a recording without poses of its own measured its scans (no paper
/// section).
#include <memory>
#include <optional>
#include <string>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/trajectory_track.h"

namespace datasets {

/// Poses of the file of `--poses`, at the times of the scans or one for each scan.
class ScanTrajectory {
 public:
  /// @param options whose `poses` is as `trajectory_in` gives it
  /// @throws ldm::InvalidInput if the file cannot be read, is none, or has times of another unit.
  explicit ScanTrajectory(const RecordingOptions& options);

  /// Of poses one for each scan, takes that of the next one.
  /// @param stamp its time [s]
  /// @throws BrokenFrame naming the line that is broken.
  void take_scan(double stamp);
  /// True if no later scan changes what `at` gives.
  bool covers(double time) const { return !lines_ || track_.covers(time); }
  /// None if there is no pose, and no gap of `longest_gap` or less, at that time [s].
  /// @throws BrokenFrame naming the line that is broken.
  std::optional<ldm::Pose> at(double time, double longest_gap);
  /// For messages: the times of the poses around.
  std::string around(double time) const;

 private:
  std::optional<TrajectoryTrack> file_;
  std::unique_ptr<PoseSequence> lines_;
  PoseTrack track_;  // of lines
};

/// @throws ldm::InvalidInput if the poses of `options` are one for each scan, and not as many.
void check_pose_count(const RecordingOptions& options, std::int64_t scans,
                      const std::string& recording);

}  // namespace datasets
