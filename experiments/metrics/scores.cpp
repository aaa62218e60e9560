#include "experiments/metrics/scores.h"

#include <numeric>

namespace experiments {
namespace {

using Value = std::optional<double>;

Value ratio(double part, double whole) {
  return whole > 0 ? Value(part / whole) : std::nullopt;
}
Value ratio(std::int64_t part, std::int64_t whole) {
  return ratio(static_cast<double>(part), static_cast<double>(whole));
}
Value percent(Value share) {
  return share ? Value(100 * *share) : std::nullopt;
}
/// A count, where a frame was scored at all.
Value count(const OccupancyTally& t, std::int64_t voxels) {
  return t.frames > 0 ? Value(static_cast<double>(voxels)) : std::nullopt;
}

Value accuracy(const Tallies& t) {
  return percent(ratio(t.occupancy.matched(), t.occupancy.voxels));
}
Value accuracy_visible(const Tallies& t) {
  const OccupancyTally& o = t.occupancy;
  return percent(ratio(o.voxels - o.case1_visible - o.case2_visible, o.voxels));
}
Value case1(const Tallies& t) {
  return count(t.occupancy, t.occupancy.case1);
}
Value case2(const Tallies& t) {
  return count(t.occupancy, t.occupancy.case2);
}
Value case1_visible(const Tallies& t) {
  return count(t.occupancy, t.occupancy.case1_visible);
}
Value case2_grown(const Tallies& t) {
  return count(t.occupancy, t.occupancy.case2_grown);
}
Value mixed(const Tallies& t) {
  return ratio(t.occupancy.case1_visible + t.occupancy.case2_grown, t.occupancy.frames);
}
Value precision(const Tallies& t) {
  return ratio(t.occupancy.true_positives, t.occupancy.true_positives + t.occupancy.case2);
}
Value recall(const Tallies& t) {
  return ratio(t.occupancy.true_positives, t.occupancy.true_positives + t.occupancy.case1);
}
Value f1(const Tallies& t) {
  const OccupancyTally& o = t.occupancy;
  return ratio(2 * o.true_positives, 2 * o.true_positives + o.case1 + o.case2);
}
Value iou_visible(const Tallies& t) {
  const OccupancyTally& o = t.occupancy;
  return ratio(o.seen, o.seen + o.case1_visible + o.invented);
}
Value brier(const Tallies& t) {
  return ratio(t.occupancy.squared_error, static_cast<double>(t.occupancy.known));
}
Value ghosts(const Tallies& t) {
  return ratio(t.ghosts.ghosts(), t.ghosts.frames());
}
Value time_to_clear(const Tallies& t) {
  return t.ghosts.time_to_clear();
}
Value static_error(const Tallies& t) {
  return t.velocity.error(false).value();
}
Value dynamic_error(const Tallies& t) {
  return t.velocity.error(true).value();
}
Value static_steady(const Tallies& t) {
  return t.velocity.steady_error(false).value();
}
Value dynamic_steady(const Tallies& t) {
  return t.velocity.steady_error(true).value();
}
Value precision_near(const Tallies& t) {
  const std::int64_t occupied = t.occupancy.true_positives + t.occupancy.case2;
  return ratio(occupied - t.occupancy.case2_grown, occupied);
}
Value mover_voxels(const Tallies& t) {
  return percent(t.movers.voxels_found().value());
}
Value movers_called_dynamic(const Tallies& t) {
  return percent(t.movers.called_dynamic().value());
}
Value false_movers(const Tallies& t) {
  return t.movers.false_movers().value();
}
Value static_error_p95(const Tallies& t) {
  return t.velocity.static_error_quantile(0.95);
}
Value recovery(const Tallies& t) {
  const std::vector<double>& times = t.velocity.recoveries();
  return ratio(std::accumulate(times.begin(), times.end(), 0.0), static_cast<double>(times.size()));
}
Value recovery_p90(const Tallies& t) {
  return quantile(t.velocity.recoveries(), 0.9);
}
Value in_ellipse(const Tallies& t) {
  return percent(t.velocity.in_ellipse().value());
}
Value switches_per_minute(const Tallies& t) {
  return t.identity.switches_per_minute();
}
Value time_to_converge(const Tallies& t) {
  return t.velocity.time_to_converge().value();
}
Value not_converged(const Tallies& t) {
  return percent(t.velocity.not_converged().value());
}
Value missed(const Tallies& t) {
  return percent(t.velocity.missed().value());
}
Value clusters_without(const Tallies& t) {
  return t.velocity.clusters_without_object().value();
}
Value tracks(const Tallies& t) {
  return t.identity.tracks().value();
}
Value track_switches(const Tallies& t) {
  return t.identity.switches().value();
}
Value occlusions_kept(const Tallies& t) {
  return percent(t.identity.kept().value());
}
Value hidden_matched(const Tallies& t) {
  return percent(t.identity.hidden_matched().value());
}

constexpr Score kScores[] = {
    {"accuracy_pct", accuracy},
    {"case1_voxels", case1},
    {"case2_voxels", case2},
    {"accuracy_visible_pct", accuracy_visible},
    {"case1_visible_voxels", case1_visible},
    {"case2_grown_voxels", case2_grown},
    {"mixed_voxels_per_frame", mixed},
    {"precision", precision},
    {"precision_near", precision_near},
    {"recall", recall},
    {"f1", f1},
    {"iou_visible", iou_visible},
    {"brier", brier},
    {"mover_voxels_found_pct", mover_voxels},
    {"ghost_voxels_per_frame", ghosts},
    {"seconds_to_clear", time_to_clear},
    {"static_velocity_error_mps", static_error},
    {"static_velocity_error_p95_mps", static_error_p95},
    {"dynamic_velocity_error_mps", dynamic_error},
    {"static_velocity_error_steady_mps", static_steady},
    {"dynamic_velocity_error_steady_mps", dynamic_steady},
    {"recovery_s", recovery},
    {"recovery_p90_s", recovery_p90},
    {"velocity_in_ellipse_pct", in_ellipse},
    {"time_to_converge_s", time_to_converge},
    {"stays_not_converged_pct", not_converged},
    {"objects_missed_pct", missed},
    {"clusters_without_object_per_frame", clusters_without},
    {"movers_called_dynamic_pct", movers_called_dynamic},
    {"false_movers_per_frame", false_movers},
    {"tracks_per_stay", tracks},
    {"track_switches_per_stay", track_switches},
    {"track_switches_per_minute", switches_per_minute},
    {"occlusions_kept_pct", occlusions_kept},
    {"hidden_with_cluster_pct", hidden_matched},
};

}  // namespace

std::span<const Score> scores() {
  return kScores;
}

}  // namespace experiments
