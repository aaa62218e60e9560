#include "experiments/metrics/velocity_score.h"

#include <Eigen/Dense>

namespace experiments {
namespace {

/// Frame times are multiples of 0.1 s only up to rounding.
constexpr double kTimeTolerance = 1e-6;

bool at_least(double duration, double wanted) {
  return duration >= wanted - kTimeTolerance;
}

/// Whether the 95 % ellipse around the estimate holds the true velocity. Requires both.
bool in_its_ellipse(const Observation& seen) {
  const Eigen::Vector2d error = (*seen.velocity - seen.true_velocity).head<2>();
  return error.dot(seen.covariance->inverse() * error) <= VelocityTally::kEllipse;
}

}  // namespace

void VelocityTally::add(const Observation& seen) {
  Track& track = tracks_[seen.object];
  track.dynamic = seen.dynamic;
  note_recovery(track, seen, note_reversal(track, seen));
  if (seen.visible) missed_.add(seen.velocity ? 0 : 1);
  if (!seen.in_map) {
    end_stay(track);
    return;
  }
  if (!track.stay) track.stay = Stay{.entered = seen.time, .last = seen.time, .good_since = {}};
  Stay& stay = *track.stay;
  stay.last = seen.time;
  if (seen.dynamic) note_convergence(stay, seen);
  if (!seen.velocity || !at_least(seen.time - stay.entered, kSettling)) return;
  const double error = (*seen.velocity - seen.true_velocity).norm();
  error_[seen.dynamic].add(error);
  if (!seen.dynamic) static_errors_.push_back(error);
  if (seen.dynamic && seen.covariance) in_ellipse_.add(in_its_ellipse(seen) ? 1 : 0);
  if (!track.reversed || at_least(seen.time - *track.reversed, kAfterReversal)) {
    steady_error_[seen.dynamic].add(error);
  }
}

bool VelocityTally::note_reversal(Track& track, const Observation& seen) const {
  bool turned = false;
  if (track.velocity) {
    const bool moved = track.velocity->norm() > kStanding;
    const bool moves = seen.true_velocity.norm() > kStanding;
    turned = moved && moves && track.velocity->dot(seen.true_velocity) < 0;
    if (moved != moves || turned) track.reversed = seen.time;
  }
  track.velocity = seen.true_velocity;
  return turned;
}

void VelocityTally::note_recovery(Track& track, const Observation& seen, bool turned) {
  if (track.turn && (turned || !seen.in_map)) end_turn(track, seen.time);
  if (turned && track.matched && seen.in_map)
    track.turn = Turn{.time = seen.time, .good_since = {}};
  track.matched = seen.in_map && seen.visible && seen.velocity;
  if (!track.turn) return;
  Turn& turn = *track.turn;
  const bool good = seen.velocity && (*seen.velocity - seen.true_velocity).norm() < kRecovered;
  if (good && turn.good_since) {
    recoveries_.push_back(*turn.good_since - turn.time);
    track.turn.reset();
  } else {
    turn.good_since = good ? std::optional(seen.time) : std::nullopt;
  }
}

/// It was not followed until `time`.
void VelocityTally::end_turn(Track& track, double time) {
  if (at_least(time - track.turn->time, kLeastRecovery)) {
    recoveries_.push_back(time - track.turn->time);
  }
  track.turn.reset();
}

void VelocityTally::note_convergence(Stay& stay, const Observation& seen) {
  if (stay.converged) return;
  const bool good = seen.velocity && (*seen.velocity - seen.true_velocity).norm() < kConverged;
  if (!good) {
    stay.good_since.reset();
    return;
  }
  if (!stay.good_since) stay.good_since = seen.time;
  if (at_least(seen.time - *stay.good_since, kConvergedTime)) {
    stay.converged = true;
    time_to_converge_.add(*stay.good_since - stay.entered);
  }
}

void VelocityTally::end_stay(Track& track) {
  if (!track.stay) return;
  const Stay& stay = *track.stay;
  if (track.dynamic && at_least(stay.last - stay.entered, kSettling)) {
    not_converged_.add(stay.converged ? 0 : 1);
  }
  track.stay.reset();
}

void VelocityTally::add_clusters_without_object(std::int64_t count) {
  clusters_without_object_.add(static_cast<double>(count));
}

void VelocityTally::finish() {
  for (auto& [object, track] : tracks_) {
    if (track.turn) end_turn(track, track.stay->last);
    end_stay(track);
  }
}

}  // namespace experiments
