#include "datasets/recording/scans/scan_timeline.h"

#include <algorithm>

#include "datasets/files/toml_node.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {

ScanTimeline::ScanTimeline(const TimelineFiles& files, const InputParameters& parameters)
    : files_(files), longest_gap_(parameters.pose_gap) {
  if (parameters.poses == PoseSource::kOdometry) {
    throw ldm::InvalidInput(
        "input.poses = odometry: allowed: with an MRPT log; log or still with a folder of scans");
  }
  if (parameters.poses == PoseSource::kStill) files_.trajectory.reset();
  if (files_.trajectory) trajectory_.emplace(*files_.trajectory);
  if (files_.times) {
    times_.emplace(*files_.times);
  } else if (!trajectory_ || !trajectory_->has_times()) {
    throw ldm::InvalidInput(
        (files_.trajectory ? files_.trajectory->string() + ": has no times"
                           : std::string("input.poses = still: needs times")) +
        ": allowed: with times.txt in the folder of the scans, or --times FILE");
  }
}

void ScanTimeline::check_length(std::int64_t scans) const {
  const auto check = [&](const std::optional<std::filesystem::path>& file) {
    if (!file) return;
    const std::int64_t lines = count_lines(*file);
    if (lines == scans) return;
    throw ldm::InvalidInput(file->string() + ": " + std::to_string(lines) + " lines: allowed: " +
                            std::to_string(scans) + ", one for each scan, or --keep-going");
  };
  check(files_.times);
  if (!by_time()) check(files_.trajectory);
}

std::int64_t ScanTimeline::longest() const {
  const std::int64_t times = files_.times ? count_lines(*files_.times) : 0;
  const bool line_by_line = files_.trajectory && !by_time();
  return std::max(times, line_by_line ? count_lines(*files_.trajectory) : 0);
}

void ScanTimeline::advance() {
  has_time_ = !times_ || times_->advance();
  has_pose_ = !trajectory_ || by_time() || trajectory_->advance();
}

StampedPose ScanTimeline::read() {
  StampedPose result;
  if (!has_time_) times_->reject("no time", "the file ends: allowed: a time for each scan");
  if (times_) result.time = times_->numbers(1, "bad time").front();
  if (!trajectory_) return result;
  if (by_time()) {
    result.pose = pose_at(result.time);
    return result;
  }
  if (!has_pose_) return trajectory_->pose();  // which says that the file has ended
  const StampedPose line = trajectory_->pose();
  result.pose = line.pose;
  if (!times_) result.time = line.time;
  return result;
}

ldm::Pose ScanTimeline::pose_at(double time) {
  while (!track_.covers(time) && trajectory_->advance()) {
    if (!track_.add(trajectory_->pose())) {
      throw BrokenFrame("bad pose",
                        trajectory_->place() + ": its time lies before that of the pose before it");
    }
  }
  if (auto pose = track_.at(time, longest_gap_)) return *pose;
  throw BrokenFrame("no pose",
                    times_->place() + ": no pose at " + decimal(time) +
                        " s: " + files_.trajectory->string() + " has " + track_.around(time) +
                        ", allowed: a gap of input.pose_gap_s = " + decimal(longest_gap_));
}

std::string ScanTimeline::place() const {
  return times_ ? times_->place() : trajectory_->place();
}

}  // namespace datasets
