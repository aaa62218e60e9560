#pragma once
/// What of a recording did not reach the mapper, by reason (no paper section).
#include <cstdint>
#include <map>
#include <string>

namespace datasets {

struct InputCounts {
  using ByReason = std::map<std::string, std::int64_t>;
  ByReason frames_skipped;  ///< repeated ones, and broken ones that `--keep-going` left out
  ByReason points_dropped;  ///< of the frames that were used
  ByReason other;           ///< for instance frames in which no ground was found

  /// Number of frames skipped for any reason.
  std::int64_t skipped() const {
    std::int64_t sum = 0;
    for (const auto& [reason, count] : frames_skipped) sum += count;
    return sum;
  }
  /// `3 frames skipped: 2 broken scan, 1 no pose`
  std::string skipped_text() const {
    std::string text = std::to_string(skipped()) + " frames skipped";
    const char* separator = ": ";
    for (const auto& [reason, count] : frames_skipped) {
      text.append(separator).append(std::to_string(count)).append(" ").append(reason);
      separator = ", ";
    }
    return text;
  }
};

}  // namespace datasets
