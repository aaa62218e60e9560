#include "experiments/method/evaluation.h"

#include <Eigen/Dense>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "experiments/method/map_check.h"
#include "experiments/method/sees_truth.h"
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
    tallies_->ghosts.add(frame.scan.time, map, grid_);
    tallies_->movers.add_returns(frame, map, grid_);
    if (velocities_) add_velocities(frame, map);
  }

  std::optional<Tallies> finish() {
    if (tallies_) {
      tallies_->ghosts.finish();
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
    tallies_->movers.add_clusters(*frame.truth, map, matching);
    for (std::size_t i = 0; i < matching.objects.size(); ++i) {
      const datasets::ObjectState& object = frame.truth->objects[i];
      const Matching::Object& matched = matching.objects[i];
      Observation seen{.object = object.id,
                       .dynamic = object.dynamic,
                       .time = frame.scan.time,
                       .in_map = matched.in_map,
                       .visible = matched.visible,
                       .true_velocity = object.velocity,
                       .velocity = {},
                       .covariance = {}};
      std::optional<std::int64_t> track;
      if (matched.cluster) {
        const ldm::Cluster& cluster = map.clusters[*matched.cluster];
        seen.velocity = cluster.velocity.cast<double>();
        if (cluster.id != 0) track = cluster.id;
        const Eigen::Matrix2d covariance = cluster.velocity_covariance.cast<double>();
        if (covariance.determinant() > 0) seen.covariance = covariance;
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
  std::optional<Tallies> tallies_;
  std::map<std::int32_t, VelocitySeries> series_;
};

}  // namespace

struct MethodEvaluation::State {
  State(const Method& method, const ldm::Parameters& parameters, const EvaluationOptions& how)
      : name(method.name),
        options(how),
        mapper(method.create(parameters)),
        scorer(method.finds_clusters, how.series) {}

  std::string name;
  EvaluationOptions options;
  std::unique_ptr<ldm::Mapper> mapper;
  ldm::LocalMap map;
  Scorer scorer;
  Evaluation result;
};

MethodEvaluation::MethodEvaluation(const Method& method, const ldm::Parameters& parameters,
                                   const EvaluationOptions& options)
    : state_(std::make_unique<State>(method, parameters, options)) {}
MethodEvaluation::~MethodEvaluation() = default;
MethodEvaluation::MethodEvaluation(MethodEvaluation&&) noexcept = default;
MethodEvaluation& MethodEvaluation::operator=(MethodEvaluation&&) noexcept = default;

void MethodEvaluation::add(const datasets::Frame& frame) {
  State& state = *state_;
  state.result.clock.start_frame();
  update(*state.mapper, frame, &state.result.clock);
  state.result.clock.end_frame();
  state.mapper->read(state.map);
  check_map(state.map, state.name, frame.index);
  state.scorer.add(frame, state.map);
  if (state.options.observer) state.options.observer(frame, state.map);
  ++state.result.frames;
}

Evaluation MethodEvaluation::finish() {
  state_->result.tallies = state_->scorer.finish();
  state_->result.series = state_->scorer.take_series();
  return std::move(state_->result);
}

Evaluation evaluate(const Method& method, const ldm::Parameters& parameters,
                    datasets::FrameSource& source, const EvaluationOptions& options) {
  MethodEvaluation evaluation(method, parameters, options);
  datasets::Frame frame;
  for (std::int64_t k = 0; (!options.frames || k < *options.frames) && source.next(frame); ++k) {
    evaluation.add(frame);
  }
  return evaluation.finish();
}

}  // namespace experiments
