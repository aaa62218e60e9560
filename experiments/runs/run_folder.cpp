#include "experiments/runs/run_folder.h"

#include <limits>

#include "datasets/files/csv.h"
#include "experiments/runs/point_labels.h"
#include "experiments/runs/run_tables.h"

namespace experiments {
namespace {

constexpr std::int64_t kAny = std::numeric_limits<std::int32_t>::max();

Eigen::Vector3d vector(datasets::CsvReader& csv) {
  const double x = csv.number(), y = csv.number(), z = csv.number();
  return {x, y, z};
}

void read_clusters(const std::filesystem::path& file, std::map<std::int64_t, RunFrame>& frames) {
  datasets::CsvReader csv(file, kClusterColumns);
  while (csv.next_row()) {
    const std::int64_t number = csv.integer(0, kAny);
    const auto frame = frames.find(number);
    if (frame == frames.end()) {
      csv.reject("frame " + std::to_string(number) + ": allowed: the frames of frames.csv");
    }
    csv.number();  // the time, which frames.csv has
    csv.integer(0, kAny);
    RunCluster found;
    found.track = csv.integer(0, std::numeric_limits<std::int64_t>::max());
    csv.number();  // its age
    found.position = vector(csv);
    vector(csv);  // the size
    found.velocity = vector(csv);
    vector(csv);           // its covariance
    csv.integer(1, kAny);  // the voxels
    csv.integer(0, kAny);  // the points
    found.dynamic = csv.integer(0, 1) == 1;
    frame->second.clusters.push_back(found);
  }
}

/// The folder, too, if nothing else is in it.
template <class Predicate>
void remove_files(const std::filesystem::path& folder, Predicate is_ours) {
  if (!std::filesystem::is_directory(folder)) return;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (is_ours(entry.path())) files.push_back(entry.path());
  }
  for (const std::filesystem::path& file : files) std::filesystem::remove(file);
  if (std::filesystem::is_empty(folder)) std::filesystem::remove(folder);
}

}  // namespace

std::map<std::int64_t, RunFrame> read_run_frames(const std::filesystem::path& folder) {
  std::map<std::int64_t, RunFrame> frames;
  datasets::CsvReader csv(folder / "frames.csv", kFrameColumns);
  while (csv.next_row()) {
    RunFrame& frame = frames[csv.integer(0, kAny)];
    frame.time = csv.number();
    vector(csv);  // the UAV
    const Eigen::Vector3d low = vector(csv);
    frame.map = {low, low + vector(csv)};
  }
  read_clusters(folder / "clusters.csv", frames);
  return frames;
}

void clear_run_folder(const std::filesystem::path& folder) {
  for (const char* name :
       {"clusters.csv", "frames.csv", "timing.csv", "summary.json", "score.csv", "score.json"}) {
    std::filesystem::remove(folder / name);
  }
  remove_files(folder / "maps", [](const std::filesystem::path& file) {
    const bool map = file.extension() == ".ply" || file.extension() == ".bt";
    return map && file.filename().string().starts_with("frame_");
  });
  for (const char* name : {kLabels, kTrueLabels}) {
    remove_files(folder / name, [](const auto& file) { return file.extension() == ".label"; });
  }
}

}  // namespace experiments
