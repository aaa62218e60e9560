#include "datasets/recording/scans/scan_timeline.h"

#include "datasets/files/text.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {
namespace {

/// @param words of a line, of which the first is a time
void check_seconds(const std::filesystem::path& file, std::size_t words) {
  constexpr std::size_t kEnough = 32;
  std::vector<double> times;
  for (NumberLines lines(file); times.size() < kEnough && lines.advance();) {
    try {
      times.push_back(lines.numbers(words, "").front());
    } catch (const BrokenFrame&) {  // which is told when its turn comes
    }
  }
  const std::optional<TimeUnit> unit = unit_other_than_seconds(times);
  if (!unit) return;
  const std::string name(kTimeUnitNames[static_cast<std::size_t>(*unit)]);
  throw ldm::InvalidInput(file.string() + ": times from " + decimal(times.front()) +
                          " on: allowed: seconds; they look like " + name + ": --time-unit " +
                          name + " (or s, if they are right)");
}

}  // namespace

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
  if (files_.trajectory) trajectory_.emplace(*files_.trajectory);
  if (files_.times) {
    times_.emplace(*files_.times);
  } else if (!trajectory_ || !trajectory_->has_times()) {
    throw ldm::InvalidInput(
        (files_.trajectory ? files_.trajectory->string() + ": has no times"
                           : std::string("input.poses = still: needs times")) +
        ": allowed: with times.txt in the folder of the scans, or --times FILE");
  }
  if (unit) return;
  if (files_.times) check_seconds(*files_.times, 1);
  if (trajectory_ && trajectory_->has_times()) {
    check_seconds(*files_.trajectory, TrajectoryFile::kTumNumbers);
  }
}

ScanTimeline::Lines ScanTimeline::lines() const {
  if (!files_.times) return {*files_.trajectory, count_lines(*files_.trajectory)};
  const Lines times{*files_.times, count_lines(*files_.times)};
  if (!files_.trajectory || by_time()) return times;
  const std::int64_t poses = count_lines(*files_.trajectory);
  if (poses == times.count) return times;
  throw ldm::InvalidInput(files_.trajectory->string() + ": " + std::to_string(poses) +
                          " lines: allowed: " + std::to_string(times.count) + ", as many as " +
                          times.file.string() + " has");
}

void ScanTimeline::advance() {
  if (times_) times_->advance();
  if (trajectory_ && !by_time()) trajectory_->advance();
}

StampedPose ScanTimeline::read() {
  StampedPose result;
  if (times_) result.time = unit_ * times_->numbers(1, "bad time").front();
  if (!trajectory_) return result;
  if (by_time()) {
    result.pose = pose_at(result.time);
    return result;
  }
  const StampedPose line = trajectory_->pose();
  result.pose = line.pose;
  if (!times_) result.time = unit_ * line.time;
  return result;
}

ldm::Pose ScanTimeline::pose_at(double time) {
  while (!track_.covers(time) && trajectory_->advance()) {
    StampedPose pose = trajectory_->pose();
    pose.time *= unit_;
    if (!track_.add(pose)) {
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
