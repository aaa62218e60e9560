#include "experiments/runs/played_frames.h"

#include <algorithm>
#include <thread>

namespace experiments {

PlayedFrames::PlayedFrames(datasets::FrameSource& source, std::optional<double> rate,
                           std::function<bool()> ended)
    : source_(source), rate_(rate), ended_(std::move(ended)) {}

bool PlayedFrames::next(datasets::Frame& frame) {
  if (ended_() || !source_.next(frame)) return false;
  if (rate_) await(frame.scan.time);
  return !ended_();
}

void PlayedFrames::await(double time) {
  constexpr double kLongestSleep = 0.05;  // [s]: Ctrl-C waits no longer
  if (!start_) start_ = {Clock::now(), time};
  const auto left = [&] {
    const std::chrono::duration<double> passed = Clock::now() - start_->clock;
    return (time - start_->time) / *rate_ - passed.count();
  };
  const double late = -left();
  if (late > kTolerance) {
    ++lateness_.frames;
    lateness_.worst = std::max(lateness_.worst, late);
  }
  while (left() > 0 && !ended_()) {
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left(), kLongestSleep)));
  }
}

}  // namespace experiments
