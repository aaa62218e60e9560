#include "datasets/recording/scans/trajectory_track.h"

#include "datasets/files/text.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {

std::optional<ldm::Pose> TrajectoryTrack::at(double time, double longest_gap) {
  while (!track_.covers(time) && poses_->advance()) {
    if (!track_.add(poses_->pose())) {
      throw BrokenFrame("bad pose",
                        poses_->place() + ": its time lies before that of the pose before it");
    }
  }
  return track_.at(time, longest_gap);
}

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

}  // namespace datasets
