#pragma once
/// What of a recording did not reach the mapper, by reason (no paper section).
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace datasets {

struct InputCounts {
  using ByReason = std::map<std::string, std::int64_t>;
  ByReason frames_skipped;  ///< repeated ones, and broken ones that `--keep-going` left out
  ByReason points_dropped;  ///< of the frames that were used
  ByReason other;           ///< for instance frames in which no ground was found
  ByReason other_sensors;   ///< scans that were left out, by the sensor they are of

  static constexpr char kNoGround[] = "frames in which no ground was found";

  /// What a user should hear of who does not look into the summary, a line each: frames skipped,
  /// scans of another sensor, and what took every point or failed in every frame.
  /// @param frames, points that were used
  std::vector<std::string> losses(std::int64_t frames, std::int64_t points) const;

  /// Number of frames skipped for any reason.
  std::int64_t skipped() const;
  /// `3 frames skipped: 2 broken scan, 1 no pose`
  std::string skipped_text() const;
};

}  // namespace datasets
