#include "ldm/cluster_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ldm {
namespace {

constexpr std::size_t kUsualTracks = 512;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// The gate: how far from its expected place an object may be found.
constexpr double kNearby = 0.6;        // [m]: about the width of a person
constexpr double kShareOfSize = 0.3;   // of something large, other parts come into view
constexpr double kDrift = 0.2;         // [m/s]: error of the velocity while unseen,
constexpr double kShareOfSpeed = 0.4;  // more for what moves

constexpr double kSizeWeight = 0.15;  // of a difference in size, against a distance
constexpr double kUnseenCost = 0.3;   // [m]: what was in view keeps its cluster
constexpr double kSmoothing = 0.3;    // [s]: time constant of the velocity
constexpr double kFragment = 0.5;     // [s]: what lasts no longer may be part of something else

// The covariance of velocities.
constexpr double kErrorTime = 0.3;     // [s]: over which a velocity is held against the way made
constexpr double kCovarianceTime = 1;  // [s]: over which the squared error is averaged
constexpr float kUnknownError = 1;     // [m/s]: standard deviation before anything is known
constexpr float kLeastError = 0.05F;   // [m/s]: centres of voxels tell no more

// What moves has gone this share of its velocity's way, in a number of frames.
constexpr float kGone = 0.5F;
constexpr std::int64_t kLeastMeasurements = 3;

/// True if both may be the size [m] of one object, of which one is half hidden.
bool similar(const Point& a, const Point& b) {
  constexpr float kFactor = 3, kMargin = 1.5F;
  return (a.array() <= kFactor * b.array() + kMargin).all() &&
         (b.array() <= kFactor * a.array() + kMargin).all();
}

Velocity velocity_of(const Cluster& cluster) {
  return cluster.dynamic ? cluster.velocity : Velocity(Velocity::Zero());
}

/// Weight of the newest of `n` in a mean that forgets with a time constant, and at first does not.
float newest_share(double dt, double time_constant, std::int64_t n) {
  return static_cast<float>(
      std::max(1 - std::exp(-dt / time_constant), 1 / static_cast<double>(n)));
}

}  // namespace

ClusterTracker::ClusterTracker() {
  // Room for what is usual; a map with more of it takes more once.
  tracks_.reserve(kUsualTracks);
  candidates_.reserve(kUsualTracks);
  track_of_.reserve(kUsualTracks);
}

ClusterTracker::Track::Track(std::int64_t number, double time, const Cluster& cluster)
    : id(number),
      since(time),
      found(time),
      measured(time),
      measured_at(cluster.position),
      position(cluster.position),
      velocity(velocity_of(cluster)),
      size(cluster.size),
      covariance(kUnknownError * kUnknownError * Eigen::Matrix2f::Identity()) {}

/// What was in view for a moment only is forgotten soon; a slow log's moment is a few frames.
bool ClusterTracker::Track::forgotten(double time) const {
  return missed > kMemoryFrames &&
         time - found > std::min(kMemory, kFragment + 4 * (found - since));
}

void ClusterTracker::Track::take(double time, const Cluster& cluster) {
  learn_error(time - measured, cluster);
  const double share = 1 - std::exp((measured - time) / kSmoothing);
  velocity += static_cast<float>(share) * (velocity_of(cluster) - velocity);
  position = measured_at = cluster.position;
  size = cluster.size;
  measured = time;
}

void ClusterTracker::Track::learn_error(double dt, const Cluster& cluster) {
  if (dt <= 0) return;
  ++measurements;
  const Eigen::Vector2f way = (cluster.position - measured_at).head<2>() / static_cast<float>(dt);
  const float share = newest_share(dt, kErrorTime, measurements - 1);
  made += share * (way - made);
  error += share * (cluster.velocity.head<2>() - way - error);
  const Eigen::Matrix2f squared =
      error * error.transpose() + kLeastError * kLeastError * Eigen::Matrix2f::Identity();
  covariance += newest_share(dt, kCovarianceTime, measurements) * (squared - covariance);
}

/// Its centre went the way that a velocity tells.
bool ClusterTracker::Track::has_gone(const Eigen::Vector2f& v) const {
  return measurements >= kLeastMeasurements && made.dot(v) >= kGone * v.squaredNorm();
}

void ClusterTracker::Track::stay_within(const Cluster& cluster) {
  position = position.cwiseMax(cluster.position - 0.5F * cluster.size)
                 .cwiseMin(cluster.position + 0.5F * cluster.size);
}

void ClusterTracker::follow(double time, std::span<Cluster> clusters) {
  std::erase_if(tracks_, [time](const Track& track) { return track.forgotten(time); });
  for (Track& track : tracks_) {
    track.position += static_cast<float>(time - time_) * track.velocity;
    ++track.missed;
  }
  find_candidates(time, clusters);
  assign(time, clusters);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    Cluster& cluster = clusters[c];
    if (track_of_[c] == kNone) {
      track_of_[c] = tracks_.size();
      tracks_.emplace_back(++last_id_, time, cluster);
    }
    const Track& track = tracks_[track_of_[c]];
    cluster.id = track.id;
    cluster.age = time - track.since;
    cluster.velocity_covariance = track.covariance;
    cluster.dynamic &= track.has_gone(cluster.velocity.head<2>());
  }
  time_ = time;
}

/// What each track may have become.
void ClusterTracker::find_candidates(double time, std::span<const Cluster> clusters) {
  candidates_.clear();
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    const Track& track = tracks_[t];
    const double unseen = track.missed > 1 ? kUnseenCost : 0;
    const double drift = kDrift + kShareOfSpeed * static_cast<double>(track.velocity.norm());
    const double gate = kNearby +
                        kShareOfSize * static_cast<double>(track.size.head<2>().maxCoeff()) +
                        drift * (time - track.measured);
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      const auto distance = static_cast<double>((clusters[c].position - track.position).norm());
      if (!(distance < gate) || !similar(track.size, clusters[c].size)) continue;
      const auto difference = static_cast<double>((clusters[c].size - track.size).norm());
      candidates_.push_back({distance + kSizeWeight * difference + unseen, t, c});
    }
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cost, a.track, a.cluster) < std::tie(b.cost, b.track, b.cluster);
  });
}

/// One cluster, one track: the best fits first.
void ClusterTracker::assign(double time, std::span<Cluster> clusters) {
  track_of_.assign(clusters.size(), kNone);
  std::erase_if(candidates_, [&](const Candidate& candidate) {
    Track& track = tracks_[candidate.track];
    if (track.missed == 0 || track_of_[candidate.cluster] != kNone) return true;
    track.found = time;
    track.missed = 0;
    track_of_[candidate.cluster] = candidate.track;
    return false;
  });
  for (const Candidate& candidate : candidates_) {
    Track& track = tracks_[candidate.track];
    const Cluster& cluster = clusters[candidate.cluster];
    if (holds_another(cluster)) {
      track.stay_within(cluster);
    } else {
      track.take(time, cluster);
    }
  }
}

/// True if a track without a cluster leads into this one: two objects are in it.
bool ClusterTracker::holds_another(const Cluster& cluster) const {
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const Track& track) {
    const Point offset = track.position - cluster.position;
    return track.missed > 0 && track.found - track.since >= kFragment &&
           (offset.array().abs() <= 0.5F * cluster.size.array()).all();
  });
}

}  // namespace ldm
