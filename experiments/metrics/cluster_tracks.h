#pragma once
/// Which clusters of different frames are the same object (the identity that Sec. 4.2 of the paper
/// claims is kept through an occlusion; the rule is ours: docs/run-output.md).
#include <cstdint>
#include <vector>

#include "experiments/metrics/nearest_pairs.h"
#include "ldm/types.h"

namespace experiments {

/// Follows clusters from frame to frame. A track moves on with its velocity while nothing is found
/// near it, and takes the cluster that appears near the place it leads to; the longer it was
/// unseen, the wider it looks. Two objects whose clusters merge both move on, and are told apart
/// again when the clusters part.
class ClusterTracks {
 public:
  static constexpr double kMemory = 4.0;            ///< unseen for longer, a track ends [s],
  static constexpr std::int64_t kMemoryFrames = 3;  ///< but not before it missed more frames

  /// The track of each cluster of the next frame, taken at `time` [s] (never decreasing): numbers
  /// from 1, each in one cluster of a frame at most, never used again after their track ended.
  /// Cost: clusters times tracks.
  std::vector<std::int64_t> next(double time, const std::vector<ldm::Cluster>& clusters);

 private:
  struct Track {
    std::int64_t id;
    double since;     ///< first seen [s]
    double found;     ///< last seen [s]
    double measured;  ///< last seen apart from other tracks [s]
    ldm::Point position;
    ldm::Velocity velocity;
    ldm::Point size;
    std::int64_t missed = 0;  ///< frames since it was last seen

    bool forgotten(double time) const;
    bool may_be(double time, const ldm::Cluster& cluster) const;
    void take(double time, const ldm::Cluster& cluster);
    void stay_within(const ldm::Cluster& cluster);
  };

  std::vector<CandidatePair> candidates(double time,
                                        const std::vector<ldm::Cluster>& clusters) const;
  bool holds_another(double time, const ldm::Cluster& cluster) const;

  double time_ = 0;  ///< of the last frame [s]
  std::int64_t last_id_ = 0;
  std::vector<Track> tracks_;  ///< by id
};

}  // namespace experiments
