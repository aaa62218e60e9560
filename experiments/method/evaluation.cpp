#include "experiments/method/evaluation.h"

#include <map>
#include <memory>
#include <utility>

#include "experiments/method/map_check.h"
#include "experiments/metrics/cluster_tracks.h"
#include "experiments/metrics/matching.h"
#include "experiments/metrics/truth_grid.h"

namespace experiments {
namespace {

/// Scores the frames of one run.
class Scorer {
 public:
  Scorer(bool velocities, bool series) : velocities_(velocities), keep_series_(series) {}

  void add(const datasets::Frame& frame, const ldm::LocalMap& map) {
    if (!frame.truth) return;
    if (!tallies_) tallies_.emplace();
    grid_.fill(*frame.truth, map.window, map.resolution);
    tallies_->occupancy.add(map, grid_);
    if (velocities_) add_velocities(frame, map);
  }

  std::optional<Tallies> finish() {
    if (tallies_) {
      tallies_->velocity.finish();
      tallies_->identity.finish();
    }
    return std::move(tallies_);
  }

  std::vector<VelocitySeries> take_series() {
    std::vector<VelocitySeries> all;
    for (auto& [object, series] : series_) all.push_back(std::move(series));
    return all;
  }

 private:
  void add_velocities(const datasets::Frame& frame, const ldm::LocalMap& map) {
    const Matching matching = match(map, grid_);
    const std::vector<std::int64_t> track_of = tracks_.next(frame.scan.time, map.clusters);
    for (std::size_t i = 0; i < matching.objects.size(); ++i) {
      const datasets::ObjectState& object = frame.truth->objects[i];
      const Matching::Object& matched = matching.objects[i];
      Observation seen{.object = object.id,
                       .dynamic = object.dynamic,
                       .time = frame.scan.time,
                       .in_map = matched.in_map,
                       .visible = matched.visible,
                       .true_velocity = object.velocity,
                       .velocity = {}};
      std::optional<std::int64_t> track;
      if (matched.cluster) {
        seen.velocity = map.clusters[*matched.cluster].velocity.cast<double>();
        track = track_of[*matched.cluster];
      }
      tallies_->velocity.add(seen);
      tallies_->identity.add({seen.object, seen.time, seen.in_map, seen.visible, track});
      if (keep_series_ && seen.in_map) add_to_series(frame.index, seen, track);
    }
    tallies_->velocity.add_clusters_without_object(matching.clusters_without_object);
  }

  void add_to_series(std::int64_t frame, const Observation& seen,
                     std::optional<std::int64_t> track) {
    VelocitySeries& series = series_[seen.object];
    series.object = seen.object;
    series.dynamic = seen.dynamic;
    series.frame.push_back(frame);
    series.time.push_back(seen.time);
    series.true_velocity.push_back(seen.true_velocity);
    series.velocity.push_back(seen.velocity);
    series.visible.push_back(seen.visible);
    series.track.push_back(track);
  }

  bool velocities_, keep_series_;
  TruthGrid grid_;
  ClusterTracks tracks_;
  std::optional<Tallies> tallies_;
  std::map<std::int32_t, VelocitySeries> series_;
};

}  // namespace

Evaluation evaluate(const Method& method, const ldm::Parameters& parameters,
                    datasets::FrameSource& source, const EvaluationOptions& options) {
  const std::unique_ptr<ldm::Mapper> mapper = method.create(parameters);
  Scorer scorer(method.finds_clusters, options.series);
  Evaluation result;
  datasets::Frame frame;
  ldm::LocalMap map;
  while ((!options.frames || result.frames < *options.frames) && source.next(frame)) {
    result.clock.start_frame();
    mapper->update(frame.scan, &result.clock);
    result.clock.end_frame();
    mapper->read(map);
    check_map(map, method.name, frame.index);
    scorer.add(frame, map);
    if (options.observer) options.observer(frame, map);
    ++result.frames;
  }
  result.tallies = scorer.finish();
  result.series = scorer.take_series();
  return result;
}

}  // namespace experiments
