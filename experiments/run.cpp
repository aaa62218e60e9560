#include "experiments/run.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "experiments/evaluation.h"
#include "experiments/partial_file.h"
#include "experiments/progress_line.h"
#include "experiments/record.h"

namespace experiments {
namespace {

void write_clusters(const datasets::Frame& frame, const ldm::LocalMap& map, std::ostream& out) {
  for (std::size_t i = 0; i < map.clusters.size(); ++i) {
    const ldm::Cluster& c = map.clusters[i];
    char line[320];
    std::snprintf(line, sizeof line,
                  "%lld,%.6f,%zu,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%d,%d\n",
                  static_cast<long long>(frame.index), frame.scan.time, i,
                  static_cast<double>(c.position.x()), static_cast<double>(c.position.y()),
                  static_cast<double>(c.position.z()), static_cast<double>(c.size.x()),
                  static_cast<double>(c.size.y()), static_cast<double>(c.size.z()),
                  static_cast<double>(c.velocity.x()), static_cast<double>(c.velocity.y()),
                  static_cast<double>(c.velocity.z()), c.voxels, c.dynamic ? 1 : 0);
    out << line;
  }
}

/// Raw times of every frame, warm-up included.
void write_timing(const StageClock& clock, std::ostream& out) {
  out << "frame";
  for (const StageClock::Stage& stage : clock.stages()) out << ',' << stage.name << "_ms";
  out << ",total_ms\n";
  for (std::size_t frame = 0; frame < clock.totals().size(); ++frame) {
    out << frame;
    for (const StageClock::Stage& stage : clock.stages()) out << ',' << stage.ms[frame];
    out << ',' << clock.totals()[frame] << '\n';
  }
}

std::string cluster_counts(const ldm::LocalMap& map) {
  const auto dynamic = std::count_if(map.clusters.begin(), map.clusters.end(),
                                     [](const ldm::Cluster& c) { return c.dynamic; });
  return std::to_string(map.clusters.size()) + " clusters, " + std::to_string(dynamic) + " dynamic";
}

std::optional<std::int64_t> expected_frames(const datasets::FrameSource& source,
                                            std::optional<std::int64_t> limit) {
  const std::optional<std::int64_t> size = source.size();
  return size && limit ? std::min(*size, *limit) : (size ? size : limit);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    throw ldm::InvalidInput(folder.string() + ": cannot be made (" + error.message() +
                            "): allowed: a folder that can be written");
  }
}

}  // namespace

void run(const RunRequest& request, const DataFolders& folders) {
  const Method& method = find_method(request.method);
  RunSummary summary{.command = request.command,
                     .method = request.method,
                     .input = request.input,
                     .parameters = parameters_of(request, method),
                     .plugin = plugin_of(method),
                     .evaluation = {}};
  const std::unique_ptr<datasets::FrameSource> source =
      open_input(request, folders, request.frames);
  make_folder(request.output);
  PartialFile clusters(request.output / "clusters.csv");
  PartialFile timing(request.output / "timing.csv");
  PartialFile json(request.output / "summary.json");

  clusters.stream() << "frame,time_s,cluster,x_m,y_m,z_m,size_x_m,size_y_m,size_z_m,"
                       "vx_mps,vy_mps,vz_mps,voxels,dynamic\n";
  ProgressLine progress(expected_frames(*source, request.frames));
  std::int64_t frames = 0;
  const auto observe = [&](const datasets::Frame& frame, const ldm::LocalMap& map) {
    write_clusters(frame, map, clusters.stream());
    progress.show(++frames, cluster_counts(map));
  };
  summary.evaluation = evaluate(method, summary.parameters, *source,
                                {.frames = request.frames, .series = false, .observer = observe});
  write_timing(summary.evaluation.clock, timing.stream());
  json.stream() << to_json(summary, provenance());
  clusters.commit();
  timing.commit();
  json.commit();
}

}  // namespace experiments
