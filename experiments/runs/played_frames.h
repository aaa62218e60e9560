#pragma once
/// A log played at its own speed, or as fast as it goes, until Ctrl-C (no paper section).
#include <chrono>
#include <functional>
#include <optional>

#include "datasets/frame.h"

namespace experiments {

/// How far behind the log a run was.
struct Lateness {
  std::int64_t frames = 0;  ///< taken later than they were due, by more than kTolerance
  double worst = 0;         ///< [s]
};

class PlayedFrames : public datasets::FrameSource {
 public:
  static constexpr double kTolerance = 0.001;  ///< [s]: how exactly a system wakes

  /// @param rate times the log's speed: a frame is due so long after the first one as their times
  ///   say, divided by `rate`. Absent: no waiting.
  /// @param ended asked before each frame and while waiting; true ends the frames
  PlayedFrames(datasets::FrameSource& source, std::optional<double> rate,
               std::function<bool()> ended);

  bool next(datasets::Frame& frame) override;
  std::optional<std::int64_t> size() const override { return source_.size(); }
  datasets::InputCounts counts() const override { return source_.counts(); }

  const Lateness& lateness() const { return lateness_; }

 private:
  using Clock = std::chrono::steady_clock;

  void await(double time);

  datasets::FrameSource& source_;
  std::optional<double> rate_;
  std::function<bool()> ended_;
  struct Start {
    Clock::time_point clock;
    double time;  ///< of the first frame [s]
  };
  std::optional<Start> start_;
  Lateness lateness_;
};

}  // namespace experiments
