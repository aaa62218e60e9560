#include "experiments/metrics/velocity_score.h"

namespace experiments {
namespace {

/// Frame times are multiples of 0.1 s only up to rounding.
constexpr double kTimeTolerance = 1e-6;

bool at_least(double duration, double wanted) {
  return duration >= wanted - kTimeTolerance;
}

}  // namespace

void VelocityTally::add(const Observation& seen) {
  Track& track = tracks_[seen.object];
  track.dynamic = seen.dynamic;
  note_reversal(track, seen);
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
  if (!track.reversed || at_least(seen.time - *track.reversed, kAfterReversal)) {
    steady_error_[seen.dynamic].add(error);
  }
}

void VelocityTally::note_reversal(Track& track, const Observation& seen) const {
  if (track.velocity) {
    const bool moved = track.velocity->norm() > kStanding;
    const bool moves = seen.true_velocity.norm() > kStanding;
    const bool turned = moved && moves && track.velocity->dot(seen.true_velocity) < 0;
    if (moved != moves || turned) track.reversed = seen.time;
  }
  track.velocity = seen.true_velocity;
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
  for (auto& [object, track] : tracks_) end_stay(track);
}

}  // namespace experiments
