#include "datasets/recording/scans/scan_timeline.h"

#include <algorithm>
#include <sstream>

#include "datasets/files/text.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/given_trajectory.h"

namespace datasets {

ScanTimeline::ScanTimeline(const TimelineFiles& files, const InputParameters& parameters,
                           std::optional<TimeUnit> unit)
    : files_(files), longest_gap_(parameters.pose_gap) {
  if (parameters.poses == PoseSource::kOdometry) {
    throw ldm::InvalidInput(
        "input.poses = odometry: allowed: with an MRPT log; log or still with a folder of scans");
  }
  if (parameters.poses == PoseSource::kStill) files_.trajectory.reset();
  if (files_.times) {
    times_.emplace(*files_.times);
    time_count_ = count_lines(*files_.times);
    unit_ = seconds_in(unit.value_or(TimeUnit::kSeconds));
    if (!unit) check_seconds(*files_.times, 1);
  } else if (const std::string& names = files_.times_of_names; !names.empty()) {
    times_.emplace(std::make_unique<std::istringstream>(names), "times in the names of the scans");
    time_count_ = std::count(names.begin(), names.end(), '\n');
    files_.times = "times in the names of the scans";
  }
  bool has_times = false;
  if (files_.trajectory) {
    poses_ = open_trajectory(*files_.trajectory, unit);
    has_times = poses_->has_times() && !counts_scans(*files_.trajectory, time_count_);
  }
  if (!times_ && (!has_times || std::filesystem::is_directory(*files_.trajectory))) {
    throw ldm::InvalidInput(
        (files_.trajectory ? files_.trajectory->string() + ": has no times of the scans"
                           : std::string("input.poses = still: needs times")) +
        ": allowed: with times.txt in the folder of the scans, or --times FILE");
  }
  if (times_ && has_times) track_.emplace(std::move(poses_));
}

ScanTimeline::Lines ScanTimeline::lines() const {
  if (!times_) return {*files_.trajectory, count_lines(*files_.trajectory)};
  Lines times{*files_.times, time_count_};
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
  if (times_) result.time = times_->time(unit_, "bad time");
  if (track_) result.pose = pose_at(result.time);
  if (!poses_) return result;
  const StampedPose line = poses_->pose();
  result.pose = line.pose;
  if (!times_) result.time = line.time;
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
