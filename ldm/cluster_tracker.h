#pragma once
/// Clusters as objects: which of different frames are the same, and how certain their velocities
/// are (the identity that paper Sec. 4.2 claims is kept through an occlusion; the rule is ours).
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ldm/types.h"

namespace ldm {

/// Follows clusters from frame to frame, whatever found them. A track moves on with its velocity
/// while nothing is found near it, and takes the cluster that appears near the place it leads to;
/// the longer it was unseen, the wider it looks. Two objects whose clusters merge both move on, and
/// are told apart again when the clusters part.
class ClusterTracker {
 public:
  static constexpr double kMemory = 4.0;            ///< unseen for longer, a track ends [s],
  static constexpr std::int64_t kMemoryFrames = 3;  ///< but not before it missed more frames

  ClusterTracker();

  /// Make the clusters of the next frame, taken at `time` [s] (never decreasing), objects: set id,
  /// age and velocity_covariance, and take back `dynamic` where the velocity may be chance: unless
  /// their centre went that way, too. The ids of a frame are different. Cost: clusters by tracks.
  ///
  /// The covariance is what the velocity's squared error seemed to be lately: against the way of
  /// the cluster's centre in about 0.3 s, on the average of about one second.
  void follow(double time, std::span<Cluster> clusters);

 private:
  struct Track {
    std::int64_t id;
    double since;     // first seen [s]
    double found;     // last seen [s]
    double measured;  // last seen apart from other tracks [s],
    Point measured_at;
    Point position;  // where it leads to
    Velocity velocity;
    Point size;
    Eigen::Matrix<float, 2, 2, Eigen::DontAlign> covariance;  // of a cluster's velocity [m^2/s^2]
    // Smoothed: the error of that velocity, and the velocity of the centre [m/s].
    Eigen::Vector2f error = Eigen::Vector2f::Zero();
    Eigen::Vector2f made = Eigen::Vector2f::Zero();
    std::int64_t measurements = 1;
    std::int64_t missed = 0;  // frames since it was last seen

    Track(std::int64_t number, double time, const Cluster& cluster);
    bool forgotten(double time) const;
    void take(double time, const Cluster& cluster);
    void learn_error(double dt, const Cluster& cluster);
    bool has_gone(const Eigen::Vector2f& v) const;
    void stay_within(const Cluster& cluster);
  };
  /// That a cluster may be a track's, and how well it fits: less is better.
  struct Candidate {
    double cost;
    std::size_t track, cluster;
  };

  void find_candidates(double time, std::span<const Cluster> clusters);
  void assign(double time, std::span<Cluster> clusters);
  bool holds_another(const Cluster& cluster) const;

  double time_ = 0;  // of the last frame [s]
  std::int64_t last_id_ = 0;
  std::vector<Track> tracks_;          // by id
  std::vector<Candidate> candidates_;  // of the frame at hand, cheapest first
  std::vector<std::size_t> track_of_;  // per cluster its position in `tracks_`, or kNone
};

}  // namespace ldm
