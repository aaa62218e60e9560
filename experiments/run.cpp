#include "experiments/run.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "datasets/rawlog.h"
#include "datasets/simulation.h"
#include "experiments/evaluation.h"
#include "experiments/partial_file.h"
#include "experiments/progress_line.h"
#include "experiments/record.h"

namespace experiments {
namespace {

ldm::Parameters resolve(const RunRequest& request, const Method& method) {
  ldm::Parameters parameters = default_parameters(method);
  parameters.execution.threads = 0;
  if (request.config) {
    for (const Setting& setting : read_settings(*request.config)) {
      apply(setting, method, parameters);
    }
  }
  for (const std::string& argument : request.settings) {
    apply(parse_setting(argument), method, parameters);
  }
  return parameters;
}

std::unique_ptr<datasets::FrameSource> open_input(const RunRequest& request,
                                                  const DataFolders& folders) {
  if (!request.input.ends_with(".rawlog")) {
    const datasets::Scenario scenario =
        datasets::read_scenario(folders.scenarios.file(request.input));
    return std::make_unique<datasets::Simulation>(scenario, request.seed.value_or(1),
                                                  request.frames);
  }
  if (request.seed) {
    throw ldm::InvalidInput("--seed " + std::to_string(*request.seed) +
                            ": allowed: with a scenario; a log has no seed");
  }
  return std::make_unique<datasets::RawlogReader>(request.input);
}

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
                     .parameters = resolve(request, method),
                     .plugin = plugin_of(method),
                     .evaluation = {}};
  const std::unique_ptr<datasets::FrameSource> source = open_input(request, folders);
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
