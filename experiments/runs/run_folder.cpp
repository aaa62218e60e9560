#include "experiments/runs/run_folder.h"

#include <limits>

#include "datasets/files/csv.h"
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
    RunCluster found{.track = csv.integer(1, std::numeric_limits<std::int64_t>::max()),
                     .cluster = {}};
    found.cluster.position = vector(csv).cast<float>();
    found.cluster.size = vector(csv).cast<float>();
    found.cluster.velocity = vector(csv).cast<float>();
    found.cluster.voxels = static_cast<std::int32_t>(csv.integer(1, kAny));
    csv.integer(0, kAny);  // the points
    found.cluster.dynamic = csv.integer(0, 1) == 1;
    frame->second.clusters.push_back(found);
  }
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

}  // namespace experiments
