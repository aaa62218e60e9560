#include "experiments/method/stage_clock.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace experiments {
namespace {

double milliseconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

}  // namespace

TimeSummary summarize(std::vector<double> samples) {
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const std::size_t n = samples.size();
  const double sum = std::accumulate(samples.begin(), samples.end(), 0.0);
  const auto rank95 = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(n)));
  return {.median = (samples[(n - 1) / 2] + samples[n / 2]) / 2,
          .mean = sum / static_cast<double>(n),
          .p95 = samples[rank95 - 1],
          .max = samples.back()};
}

void StageClock::start_frame() {
  for (Stage& stage : stages_) stage.ms.push_back(0);
  frame_began_ = Clock::now();
}

void StageClock::begin(std::string_view stage) {
  const Clock::time_point now = Clock::now();
  end_stage(now);
  auto known =
      std::find_if(stages_.begin(), stages_.end(), [&](const Stage& s) { return s.name == stage; });
  if (known == stages_.end()) {
    stages_.push_back({stage, std::vector<double>(totals_.size() + 1, 0)});
    known = stages_.end() - 1;
  }
  running_ = &*known;
  stage_began_ = now;
}

void StageClock::end_stage(Clock::time_point now) {
  if (running_ != nullptr) running_->ms.back() += milliseconds(now - stage_began_);
  running_ = nullptr;
}

void StageClock::end_frame() {
  const Clock::time_point now = Clock::now();
  end_stage(now);
  totals_.push_back(milliseconds(now - frame_began_));
}

}  // namespace experiments
