#include "experiments/metrics/identity_score.h"

namespace experiments {

void IdentityTally::add(const Sighting& seen) {
  if (!seen.in_map) {
    const auto found = stays_.find(seen.object);
    if (found == stays_.end()) return;
    end_stay(found->second);
    stays_.erase(found);
    return;
  }
  const auto [place, entered] = stays_.try_emplace(seen.object);
  Stay& stay = place->second;
  if (entered) stay.entered = seen.time;
  stay.last_time = seen.time;
  if (!seen.visible && stay.last) {
    hidden_matched_.add(seen.track ? 1 : 0);
    if (!stay.before) stay.before = stay.last;
    stay.ended.reset();
  }
  if (seen.visible && stay.before) judge(stay, seen);
  if (seen.track) follow(stay, seen);
}

void IdentityTally::follow(Stay& stay, const Sighting& seen) {
  stay.tracks.insert(*seen.track);
  if (stay.last && *stay.last != *seen.track) ++stay.switches;
  stay.last = seen.track;
}

void IdentityTally::judge(Stay& stay, const Sighting& seen) {
  if (!stay.ended) stay.ended = seen.time;
  const bool late = seen.time - *stay.ended > kFoundAgain;
  if (!seen.track && !late) return;
  kept_.add(seen.track == stay.before ? 1 : 0);
  stay.before.reset();
  stay.ended.reset();
}

void IdentityTally::end_stay(const Stay& stay) {
  if (stay.tracks.empty()) return;
  all_switches_ += stay.switches;
  seconds_ += stay.last_time - stay.entered;
  tracks_.add(static_cast<double>(stay.tracks.size()));
  switches_.add(static_cast<double>(stay.switches));
}

std::optional<double> IdentityTally::switches_per_minute() const {
  if (seconds_ == 0) return {};
  return static_cast<double>(all_switches_) / (seconds_ / 60);
}

void IdentityTally::finish() {
  for (auto& [object, stay] : stays_) end_stay(stay);
}

}  // namespace experiments
