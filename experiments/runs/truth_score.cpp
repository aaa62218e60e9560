#include "experiments/runs/truth_score.h"

#include <cmath>
#include <optional>
#include <set>

#include "experiments/metrics/nearest_pairs.h"

namespace experiments {
namespace {

class Scorer {
 public:
  explicit Scorer(double gate) : gate_(gate) {}

  void add(const RunFrame& frame, const std::vector<TruthObject>& objects) {
    ++score_.frames;
    std::vector<bool> object_matched(objects.size()), cluster_matched(frame.clusters.size());
    for (const CandidatePair& pair : nearest_pairs(candidates(frame, objects))) {
      object_matched[pair.left] = cluster_matched[pair.right] = true;
      add_match(objects[pair.left], frame.clusters[pair.right], frame.map);
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const bool in_map = frame.map.contains(objects[i].position);
      if (in_map && !object_matched[i]) {
        count(objects[i]);
        if (objects[i].moves()) score_.recall.add(0);
      }
      if (!in_map) tracks_[objects[i].id].last.reset();  // its stay in the map has ended
    }
    for (std::size_t i = 0; i < frame.clusters.size(); ++i) {
      if (!cluster_matched[i] && frame.clusters[i].dynamic) {
        ++score_.dynamic_without_object;
        score_.precision.add(0);
      }
    }
  }

  TruthScore finish() {
    for (auto& [id, object] : score_.objects) {
      object.score.tracks = static_cast<std::int64_t>(tracks_[id].all.size());
      ObjectScore& sum = sum_of(object.dynamic);
      ++sum.objects;
      sum.tracks += object.score.tracks;
    }
    return score_;
  }

 private:
  struct Tracks {
    std::set<std::int64_t> all;
    std::optional<std::int64_t> last;
  };

  std::vector<CandidatePair> candidates(const RunFrame& frame,
                                        const std::vector<TruthObject>& objects) const {
    std::vector<CandidatePair> result;
    for (std::size_t o = 0; o < objects.size(); ++o) {
      const Eigen::Vector3d half = objects[o].size / 2;
      const Eigen::AlignedBox3d box(objects[o].position - half, objects[o].position + half);
      for (std::size_t c = 0; c < frame.clusters.size(); ++c) {
        const Eigen::Vector3d& centroid = frame.clusters[c].position;
        if (box.exteriorDistance(centroid) > gate_) continue;
        result.push_back({(centroid - objects[o].position).norm(), o, c});
      }
    }
    return result;
  }

  ObjectScore& sum_of(bool dynamic) { return dynamic ? score_.of_dynamic : score_.of_static; }

  /// One more frame of the object in the map.
  TruthScore::Object& count(const TruthObject& object) {
    TruthScore::Object& entry = score_.objects[object.id];
    entry.dynamic = object.dynamic;
    entry.score.objects = 1;
    ++entry.score.frames;
    ++sum_of(object.dynamic).frames;
    return entry;
  }

  /// An object whose centre is out of the map is not judged by the part of it within.
  void add_match(const TruthObject& object, const RunCluster& found,
                 const Eigen::AlignedBox3d& map) {
    if (found.dynamic && !object.dynamic) ++score_.dynamic_on_static;
    if (found.dynamic) score_.precision.add(object.moves() ? 1 : 0);
    if (!map.contains(object.position)) return;
    if (object.moves()) score_.recall.add(found.dynamic ? 1 : 0);
    Tracks& tracks = tracks_[object.id];
    const bool followed = found.track != 0;
    const bool switched = followed && tracks.last && *tracks.last != found.track;
    if (followed) {
      tracks.all.insert(found.track);
      tracks.last = found.track;
    }
    for (ObjectScore* score : {&count(object).score, &sum_of(object.dynamic)}) {
      score->position_error.add((found.position - object.position).norm());
      score->velocity_error.add((found.velocity - object.velocity).norm());
      if (switched) ++score->switches;
    }
  }

  double gate_;
  TruthScore score_;
  std::map<std::int64_t, Tracks> tracks_;  ///< by object
};

void check_time(std::int64_t number, double run, double truth) {
  constexpr double kTolerance = 0.001;  // [s]
  if (std::abs(run - truth) <= kTolerance) return;
  throw ldm::InvalidInput("frame " + std::to_string(number) +
                          ": time_s = " + std::to_string(truth) +
                          ": allowed: " + std::to_string(run) + ", its time in the run");
}

}  // namespace

TruthScore score(const std::map<std::int64_t, RunFrame>& run, const TruthTable& truth,
                 double gate) {
  Scorer scorer(gate);
  std::int64_t not_run = 0;
  for (const auto& [number, reference] : truth) {
    const auto frame = run.find(number);
    if (frame == run.end()) {
      ++not_run;
      continue;
    }
    if (reference.time) check_time(number, frame->second.time, *reference.time);
    scorer.add(frame->second, reference.objects);
  }
  TruthScore result = scorer.finish();
  if (result.frames == 0) {
    throw ldm::InvalidInput("no frame of the truth is in the run: allowed: the same numbers");
  }
  result.not_run = not_run;
  return result;
}

}  // namespace experiments
