#pragma once
/// A line on the terminal that shows how far a run is (no paper section).
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace experiments {

/// Rewrites one line of stderr a few times a second; silent if stderr is no terminal.
class ProgressLine {
 public:
  /// @param total number of frames, where known
  explicit ProgressLine(std::optional<std::int64_t> total);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @param detail what else to tell, for instance the number of clusters
  void show(std::int64_t frames, const std::string& detail);

 private:
  using Clock = std::chrono::steady_clock;

  /// In minutes and seconds, where the total is known.
  std::string time_left(std::int64_t frames, double seconds) const;

  std::optional<std::int64_t> total_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point began_, last_;
};

}  // namespace experiments
