#pragma once
/// Sums behind the scores of identity: whether an object keeps its track, above all while another
/// hides it (paper Sec. 4.2.2, Fig. 12; the scores are ours).
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "experiments/metrics/mean.h"

namespace experiments {

/// One object in one frame, in the map or not.
struct Sighting {
  std::int32_t object = 0;
  double time = 0;  ///< [s]
  bool in_map = false;
  bool visible = false;
  std::optional<std::int64_t> track;  ///< of the matched cluster
};

/// Follows every object through its stays in the map.
///
/// An occlusion begins when an object that was tracked in this stay is no longer visible, and ends
/// when it is visible again.
class IdentityTally {
 public:
  static constexpr double kFoundAgain = 1.0;  ///< later after an occlusion, the track is lost [s]

  /// Frames in the order of time.
  void add(const Sighting& seen);
  /// Ends the stays that are still open. Nothing may be added afterwards.
  void finish();

  /// Different tracks of a stay in which there was one.
  const Mean& tracks() const { return tracks_; }
  /// How often the track of such a stay changed from one matched frame to the next.
  const Mean& switches() const { return switches_; }
  /// The same over all stays, a minute in which an object was in the map; none of no time.
  std::optional<double> switches_per_minute() const;
  /// 1 per occlusion with the same track before and after, 0 per other one.
  const Mean& kept() const { return kept_; }
  /// 1 per frame of an occlusion with a matched cluster, 0 per other such frame.
  const Mean& hidden_matched() const { return hidden_matched_; }

 private:
  struct Stay {
    std::set<std::int64_t> tracks;
    std::optional<std::int64_t> last;   ///< of the last matched frame
    double entered = 0, last_time = 0;  ///< [s]
    std::int64_t switches = 0;
    std::optional<std::int64_t> before;  ///< the occlusion; set until it is judged
    std::optional<double> ended;         ///< when the object came back into view [s]
  };

  void follow(Stay& stay, const Sighting& seen);
  void judge(Stay& stay, const Sighting& seen);
  void end_stay(const Stay& stay);

  std::map<std::int32_t, Stay> stays_;
  std::int64_t all_switches_ = 0;
  double seconds_ = 0;  // of all stays with a track
  Mean tracks_, switches_, kept_, hidden_matched_;
};

}  // namespace experiments
