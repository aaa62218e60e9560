#pragma once
/// When and where the scans of a folder were taken: its trajectory and times, line by line (no
/// paper section).
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "datasets/recording/scans/input_parameters.h"
#include "datasets/recording/scans/time_unit.h"
#include "datasets/recording/scans/trajectory_track.h"

namespace datasets {

/// The files that tell it; where `times` is absent, the trajectory has them.
struct TimelineFiles {
  /// As `trajectory_in` gives it; absent: input.poses = still.
  std::optional<std::filesystem::path> trajectory;
  std::optional<std::filesystem::path> times;  ///< one time a line
  std::string times_of_names;  ///< else the text of such a file, in seconds; or empty
};

/// Time and pose of scan after scan. A trajectory with times of its own (TUM, oxts) is interpolated
/// at those of `times`; in any other case line k belongs to scan k.
class ScanTimeline {
 public:
  /// @throws ldm::InvalidInput if a file cannot be read, if there is no source of times or poses,
  /// or if the times look like another unit than `unit` or, by default, seconds.
  ScanTimeline(const TimelineFiles& files, const InputParameters& parameters,
               std::optional<TimeUnit> unit);

  /// The file that has a line for each scan, and how many it has.
  /// @throws ldm::InvalidInput if there are two such files, and they have not equally many.
  struct Lines {
    std::filesystem::path file;
    std::int64_t count = 0;
  };
  Lines lines() const;

  /// To the next scan (in the beginning, to the first).
  void advance();
  /// Of that scan; to be called once.
  /// @throws BrokenFrame naming file and line.
  StampedPose read();
  /// Where the time of that scan stands.
  std::string place() const;

 private:
  ldm::Pose pose_at(double time);

  TimelineFiles files_;
  double longest_gap_;
  double unit_ = 1;  // of the times [s]
  std::optional<NumberLines> times_;
  std::int64_t time_count_ = 0;
  std::unique_ptr<PoseSequence> poses_;   // one a scan
  std::optional<TrajectoryTrack> track_;  // or at the times
};

}  // namespace datasets
