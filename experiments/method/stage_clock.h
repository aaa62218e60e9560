#pragma once
/// Wall time of a mapper's updates, stage by stage (paper Sec. 4.1.2: 98 ms in all).
#include <chrono>
#include <string_view>
#include <vector>

#include "ldm/mapper.h"

namespace experiments {

/// Mean and order statistics of samples; all 0 for no samples.
struct TimeSummary {
  double median = 0, mean = 0, p95 = 0, max = 0;
};
TimeSummary summarize(std::vector<double> samples);

/// Keeps every sample: 8 bytes a stage and frame.
class StageClock : public ldm::StageListener {
 public:
  struct Stage {
    std::string_view name;
    std::vector<double> ms;  ///< per frame [ms]; 0 in a frame without the stage
  };

  void start_frame();
  void begin(std::string_view stage) override;
  void end_frame();

  /// In the order of their first beginning.
  const std::vector<Stage>& stages() const { return stages_; }
  /// Whole updates per frame [ms].
  const std::vector<double>& totals() const { return totals_; }

 private:
  using Clock = std::chrono::steady_clock;

  void end_stage(Clock::time_point now);

  std::vector<Stage> stages_;
  std::vector<double> totals_;
  Stage* running_ = nullptr;
  Clock::time_point frame_began_, stage_began_;
};

}  // namespace experiments
