#include "datasets/recording/scans/given_trajectory.h"

#include <algorithm>

#include "datasets/files/text.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/oxts_trajectory.h"
#include "datasets/recording/scans/trajectory_track.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKissKitti = "_poses_kitti.txt", kKissTum = "_poses_tum.txt";

std::vector<std::string> files_with(const fs::path& folder, std::string_view ending) {
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().ends_with(ending)) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path trajectory_in(const fs::path& path) {
  if (!fs::is_directory(path) || is_oxts(path)) return path;
  for (const fs::path& folder : {path, path / "latest"}) {
    for (const std::string_view ending : {kKissKitti, kKissTum}) {
      const std::vector<std::string> files = files_with(folder, ending);
      if (files.size() == 1) return files.front();
      if (files.size() > 1) {
        throw ldm::InvalidInput(path.string() +
                                ": several trajectories: allowed: --poses with one "
                                "of " +
                                joined(files));
      }
    }
  }
  throw ldm::InvalidInput(path.string() +
                          ": has no trajectory: allowed: a file, KISS-ICP's results with a "
                          "*_poses_kitti.txt, or oxts/ of KITTI's raw data");
}

std::unique_ptr<PoseSequence> open_trajectory(const fs::path& path, std::optional<TimeUnit> unit) {
  if (fs::is_directory(path)) return std::make_unique<OxtsTrajectory>(path);
  auto file = std::make_unique<TrajectoryFile>(path, seconds_in(unit.value_or(TimeUnit::kSeconds)));
  if (!unit && file->has_times()) check_seconds(path, TrajectoryFile::kTumNumbers);
  return file;
}

bool counts_scans(const fs::path& path, std::int64_t scans) {
  if (fs::is_directory(path)) return false;
  TrajectoryFile file(path);
  if (!file.has_times()) return true;
  std::int64_t lines = 0;
  try {
    for (; file.advance(); ++lines) {
      if (file.pose().time != static_cast<double>(lines)) return false;
    }
  } catch (const BrokenFrame&) {  // which is told when its turn comes
    return false;
  }
  return lines == scans || path.filename().string().ends_with(kKissTum);
}

}  // namespace datasets
