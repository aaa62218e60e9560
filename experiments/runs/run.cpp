#include "experiments/runs/run.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "datasets/files/partial_file.h"
#include "experiments/method/evaluation.h"
#include "experiments/runs/interruption.h"
#include "experiments/runs/played_frames.h"
#include "experiments/runs/point_labels.h"
#include "experiments/runs/progress_line.h"
#include "experiments/runs/run_folder.h"
#include "experiments/runs/run_summary.h"
#include "experiments/runs/run_tables.h"
#include "ldm/read_occupancy.h"

namespace experiments {
namespace {

std::string progress_detail(const ldm::LocalMap& map, const Lateness& late) {
  std::string text = std::to_string(map.clusters.size()) + " clusters, " +
                     std::to_string(map.dynamic_clusters()) + " dynamic";
  if (late.frames > 0) text += ", " + std::to_string(late.frames) + " frames late";
  return text;
}

std::optional<std::int64_t> expected_frames(const datasets::FrameSource& source,
                                            std::optional<std::int64_t> limit) {
  const std::optional<std::int64_t> size = source.size();
  return size && limit ? std::min(*size, *limit) : (size ? size : limit);
}

/// The tables of a run: together, or none.
class RunTables {
 public:
  explicit RunTables(const std::filesystem::path& folder)
      : clusters_(folder / "clusters.csv"),
        frames_(folder / "frames.csv"),
        timing_(folder / "timing.csv"),
        summary_(folder / "summary.json"),
        cluster_rows_(clusters_.stream(), kClusterColumns),
        frame_rows_(frames_.stream(), kFrameColumns) {}

  void add(const datasets::Frame& frame, const ldm::LocalMap& map) {
    write_clusters(frame, map, cluster_rows_);
    write_frame(frame, map, frame_rows_);
    numbers_.push_back(frame.index);
  }

  void finish(const RunSummary& summary) {
    write_timing(numbers_, summary.evaluation.clock, timing_.stream());
    summary_.stream() << to_json(summary, provenance());
    datasets::commit_together({&clusters_, &frames_, &timing_, &summary_});
  }

 private:
  datasets::PartialFile clusters_, frames_, timing_, summary_;
  datasets::CsvWriter cluster_rows_, frame_rows_;
  std::vector<std::int64_t> numbers_;  // of the frames: a recording may have gaps
};

/// The labels of a frame's points, and the true ones if they are known.
void save_labels(const datasets::Frame& frame, const ldm::LocalMap& map,
                 const std::filesystem::path& folder) {
  datasets::make_folder(folder / kLabels);
  write_labels(labels_of(frame, map), label_file(folder / kLabels, frame.index));
  if (!frame.truth) return;
  datasets::make_folder(folder / kTrueLabels);
  write_labels(true_labels(frame), label_file(folder / kTrueLabels, frame.index));
}

/// Before the first frame.
RunSummary summary_of(const RunRequest& request, const Method& method, const DataFolders& folders) {
  return {.command = request.command,
          .request = request,
          .parameters = parameters_of(request, method, folders),
          .input_parameters = input_parameters_of(request, folders),
          .scenario_settings = scenario_settings_of(request, folders),
          .input_counts = {},
          .origin = Eigen::Vector3d::Zero(),
          .plugin = plugin_of(method),
          .real_time = {},
          .interrupted = false,
          .evaluation = {}};
}

/// What the user should know without looking into the files.
/// @param points that were used
void report(const RunSummary& summary, std::int64_t points) {
  const std::int64_t frames = summary.evaluation.frames;
  for (const std::string& line : summary.input_counts.losses(frames, points)) {
    std::fprintf(stderr, "ldm: %s\n", line.c_str());
  }
  if (summary.real_time) {
    const auto& [rate, late] = *summary.real_time;
    std::printf("played at %g times the log's speed: %lld frames came late, the worst by %.3f s\n",
                rate, static_cast<long long>(late.frames), late.worst);
  }
  if (summary.interrupted) {
    throw std::runtime_error("interrupted after " + std::to_string(frames) +
                             " frames, which are written");
  }
  if (frames == 0) throw std::runtime_error(summary.request.input + ": no frame could be used");
}

}  // namespace

void run(const RunRequest& request, const DataFolders& folders) {
  const Method& method = find_method(request.method);
  RunSummary summary = summary_of(request, method, folders);
  SavedMaps maps(request.save, request.output / "maps");
  const std::unique_ptr<datasets::FrameSource> source =
      open_input(request, folders, request.frames);
  const Interruption interruption;  // before there is anything that Ctrl-C could lose
  datasets::make_folder(request.output);
  clear_run_folder(request.output);
  RunTables tables(request.output);

  PlayedFrames frames(*source, request.rate, [&] { return interruption.requested(); });
  std::int64_t done = 0, points = 0;
  {
    ProgressLine progress(expected_frames(*source, request.frames));
    const auto observe = [&](const datasets::Frame& frame, ldm::LocalMap& map) {
      ldm::count_points(frame.scan, map);
      tables.add(frame, map);
      maps.add(frame, map);
      if (request.save_labels) save_labels(frame, map, request.output);
      summary.origin = frame.origin;
      points += static_cast<std::int64_t>(frame.scan.points.size());
      progress.show(++done, progress_detail(map, frames.lateness()));
    };
    summary.evaluation = evaluate(method, summary.parameters, frames,
                                  {.frames = request.frames, .series = false, .observer = observe});
  }
  summary.input_counts = source->counts();
  summary.interrupted = interruption.requested();
  if (request.rate) summary.real_time = {*request.rate, frames.lateness()};
  tables.finish(summary);
  report(summary, points);
  maps.check_complete();
}

}  // namespace experiments
