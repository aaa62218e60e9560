#include "datasets/recording/scans/scan_timeline.h"

#include "datasets/files/text.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {

ScanTimeline::ScanTimeline(const TimelineFiles& files, const InputParameters& parameters,
                           std::optional<TimeUnit> unit)
    : files_(files),
      longest_gap_(parameters.pose_gap),
      unit_(seconds_in(unit.value_or(TimeUnit::kSeconds))) {
  if (parameters.poses == PoseSource::kOdometry) {
    throw ldm::InvalidInput(
        "input.poses = odometry: allowed: with an MRPT log; log or still with a folder of scans");
  }
  if (parameters.poses == PoseSource::kStill) files_.trajectory.reset();
  if (files_.trajectory) poses_.emplace(*files_.trajectory);
  const bool has_times = poses_ && poses_->has_times();
  if (files_.times) {
    times_.emplace(*files_.times);
  } else if (!has_times) {
    throw ldm::InvalidInput(
        (files_.trajectory ? files_.trajectory->string() + ": has no times"
                           : std::string("input.poses = still: needs times")) +
        ": allowed: with times.txt in the folder of the scans, or --times FILE");
  }
  if (!unit && files_.times) check_seconds(*files_.times, 1);
  if (!unit && has_times) check_seconds(*files_.trajectory, TrajectoryFile::kTumNumbers);
  if (!times_ || !has_times) return;
  track_.emplace(std::move(*poses_), unit_);
  poses_.reset();
}

ScanTimeline::Lines ScanTimeline::lines() const {
  if (!files_.times) return {*files_.trajectory, count_lines(*files_.trajectory)};
  Lines times{*files_.times, count_lines(*files_.times)};
  if (!poses_) return times;
  const std::int64_t poses = count_lines(*files_.trajectory);
  if (poses == times.count) return times;
  throw ldm::InvalidInput(files_.trajectory->string() + ": " + std::to_string(poses) +
                          " lines: allowed: " + std::to_string(times.count) + ", as many as " +
                          times.file.string() + " has");
}

void ScanTimeline::advance() {
  if (times_) times_->advance();
  if (poses_) poses_->advance();
}

StampedPose ScanTimeline::read() {
  StampedPose result;
  if (times_) result.time = unit_ * times_->numbers(1, "bad time").front();
  if (track_) result.pose = pose_at(result.time);
  if (!poses_) return result;
  const StampedPose line = poses_->pose();
  result.pose = line.pose;
  if (!times_) result.time = unit_ * line.time;
  return result;
}

ldm::Pose ScanTimeline::pose_at(double time) {
  if (auto pose = track_->at(time, longest_gap_)) return *pose;
  throw BrokenFrame("no pose",
                    times_->place() + ": no pose at " + decimal(time) +
                        " s: " + files_.trajectory->string() + " has " + track_->around(time) +
                        ", allowed: a gap of input.pose_gap_s = " + decimal(longest_gap_));
}

std::string ScanTimeline::place() const {
  return times_ ? times_->place() : poses_->place();
}

}  // namespace datasets
