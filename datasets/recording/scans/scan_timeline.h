#pragma once
/// When and where the scans of a folder were taken: its trajectory and times, line by line (no
/// paper section).
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "datasets/recording/scans/input_parameters.h"
#include "datasets/recording/scans/trajectory.h"

namespace datasets {

/// The files that tell it; where `times` is absent, the trajectory has them.
struct TimelineFiles {
  std::optional<std::filesystem::path> trajectory;  ///< absent: input.poses = still
  std::optional<std::filesystem::path> times;       ///< one time a line [s]
};

/// Time and pose of scan after scan. A trajectory with times of its own (TUM) is interpolated at
/// those of `times`; in any other case line k belongs to scan k.
class ScanTimeline {
 public:
  /// @throws ldm::InvalidInput if a file cannot be read, or there is no source of times or poses.
  ScanTimeline(const TimelineFiles& files, const InputParameters& parameters);

  /// @throws ldm::InvalidInput naming the file whose number of lines is not `scans`.
  void check_length(std::int64_t scans) const;
  /// Largest number of scans that a file has a line for.
  std::int64_t longest() const;

  /// To the next scan (in the beginning, to the first).
  void advance();
  /// Of that scan; to be called once.
  /// @throws BrokenFrame naming file and line.
  StampedPose read();
  /// Where the time of that scan stands.
  std::string place() const;

 private:
  bool by_time() const { return times_ && trajectory_ && trajectory_->has_times(); }
  ldm::Pose pose_at(double time);

  TimelineFiles files_;
  double longest_gap_;
  std::optional<NumberLines> times_;
  std::optional<TrajectoryFile> trajectory_;
  bool has_time_ = true, has_pose_ = true;  // the files have a line for the scan
  PoseTrack track_;
};

}  // namespace datasets
