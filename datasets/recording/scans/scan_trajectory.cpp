#include "datasets/recording/scans/scan_trajectory.h"

#include "datasets/recording/scans/given_trajectory.h"

namespace datasets {

ScanTrajectory::ScanTrajectory(const RecordingOptions& options) {
  auto poses = open_trajectory(*options.poses, options.time_unit);
  if (counts_scans(*options.poses, 0)) {
    lines_ = std::move(poses);
  } else {
    file_.emplace(std::move(poses));
  }
}

void ScanTrajectory::take_scan(double stamp) {
  if (!lines_) return;
  lines_->advance();
  track_.add({stamp, lines_->pose().pose});
}

std::optional<ldm::Pose> ScanTrajectory::at(double time, double longest_gap) {
  return lines_ ? track_.at(time, longest_gap) : file_->at(time, longest_gap);
}

std::string ScanTrajectory::around(double time) const {
  return lines_ ? track_.around(time) : file_->around(time);
}

void check_pose_count(const RecordingOptions& options, std::int64_t scans,
                      const std::string& recording) {
  const std::int64_t lines = count_lines(*options.poses);
  if (lines == scans) return;
  throw ldm::InvalidInput(options.poses->string() + ": " + std::to_string(lines) +
                          " lines: allowed: " + std::to_string(scans) + ", one for each scan of " +
                          recording + ", or a trajectory with times (TUM)");
}

}  // namespace datasets
