#include "experiments/metrics/cluster_tracks.h"

#include <algorithm>
#include <cmath>

namespace experiments {
namespace {

// The gate: how far from its expected place an object may be found.
constexpr double kNearby = 0.6;        // [m]: about the width of a person
constexpr double kShareOfSize = 0.3;   // of something large, other parts come into view
constexpr double kDrift = 0.2;         // [m/s]: error of the velocity while unseen,
constexpr double kShareOfSpeed = 0.4;  // more for what moves

constexpr double kSizeWeight = 0.15;  // of a difference in size, against a distance
constexpr double kUnseenCost = 0.3;   // [m]: what was in view keeps its cluster
constexpr double kSmoothing = 0.3;    // [s]: time constant of the velocity
constexpr double kFragment = 0.5;     // [s]: what lasts no longer may be part of something else

/// True if both may be the size [m] of one object, of which one is half hidden.
bool similar(const ldm::Point& a, const ldm::Point& b) {
  constexpr float kFactor = 3, kMargin = 1.5F;
  return (a.array() <= kFactor * b.array() + kMargin).all() &&
         (b.array() <= kFactor * a.array() + kMargin).all();
}

ldm::Velocity velocity_of(const ldm::Cluster& cluster) {
  return cluster.dynamic ? cluster.velocity : ldm::Velocity(ldm::Velocity::Zero());
}

}  // namespace

/// What was in view for a moment only is forgotten soon; a slow log's moment is a few frames.
bool ClusterTracks::Track::forgotten(double time) const {
  return missed > kMemoryFrames &&
         time - found > std::min(kMemory, kFragment + 4 * (found - since));
}

bool ClusterTracks::Track::may_be(double time, const ldm::Cluster& cluster) const {
  const double drift = kDrift + kShareOfSpeed * static_cast<double>(velocity.norm());
  const double gate = kNearby + kShareOfSize * static_cast<double>(size.head<2>().maxCoeff()) +
                      drift * (time - measured);
  return static_cast<double>((cluster.position - position).norm()) < gate &&
         similar(size, cluster.size);
}

void ClusterTracks::Track::take(double time, const ldm::Cluster& cluster) {
  const double share = 1 - std::exp((measured - time) / kSmoothing);
  velocity += static_cast<float>(share) * (velocity_of(cluster) - velocity);
  position = cluster.position;
  size = cluster.size;
  measured = time;
}

void ClusterTracks::Track::stay_within(const ldm::Cluster& cluster) {
  position = position.cwiseMax(cluster.position - 0.5F * cluster.size)
                 .cwiseMin(cluster.position + 0.5F * cluster.size);
}

std::vector<std::int64_t> ClusterTracks::next(double time,
                                              const std::vector<ldm::Cluster>& clusters) {
  std::erase_if(tracks_, [time](const Track& track) { return track.forgotten(time); });
  for (Track& track : tracks_) {
    track.position += static_cast<float>(time - time_) * track.velocity;
    ++track.missed;
  }

  const std::vector<CandidatePair> pairs = nearest_pairs(candidates(time, clusters));
  std::vector<std::int64_t> ids(clusters.size());
  for (const CandidatePair& pair : pairs) {
    tracks_[pair.left].found = time;
    tracks_[pair.left].missed = 0;
    ids[pair.right] = tracks_[pair.left].id;
  }
  for (const CandidatePair& pair : pairs) {
    Track& track = tracks_[pair.left];
    const ldm::Cluster& cluster = clusters[pair.right];
    if (holds_another(time, cluster)) {
      track.stay_within(cluster);
    } else {
      track.take(time, cluster);
    }
  }
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    if (ids[c] != 0) continue;
    ids[c] = ++last_id_;
    tracks_.push_back({last_id_, time, time, time, clusters[c].position, velocity_of(clusters[c]),
                       clusters[c].size});
  }
  time_ = time;
  return ids;
}

std::vector<CandidatePair> ClusterTracks::candidates(
    double time, const std::vector<ldm::Cluster>& clusters) const {
  std::vector<CandidatePair> result;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    const Track& track = tracks_[t];
    const double unseen = track.found < time_ ? kUnseenCost : 0;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      if (!track.may_be(time, clusters[c])) continue;
      const float distance = (clusters[c].position - track.position).norm();
      const float difference = (clusters[c].size - track.size).norm();
      result.push_back(
          {static_cast<double>(distance) + kSizeWeight * static_cast<double>(difference) + unseen,
           t, c});
    }
  }
  return result;
}

/// True if a track without a cluster leads into this one: two objects are in it.
bool ClusterTracks::holds_another(double time, const ldm::Cluster& cluster) const {
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const Track& track) {
    const ldm::Point offset = track.position - cluster.position;
    return track.found < time && track.found - track.since >= kFragment &&
           (offset.array().abs() <= 0.5F * cluster.size.array()).all();
  });
}

}  // namespace experiments
