#pragma once
/// Times many subjects in turns, so that noise of the machine hits all alike (no paper section).
#include <memory>
#include <vector>

#include "experiments/benchmarks/subject.h"
#include "experiments/method/stage_clock.h"

namespace benchmarks {

/// Steps that a subject does before the next one has its turn. The first of them finds the caches
/// as another subject left them and does not count.
inline constexpr std::size_t kTurn = 4;
/// Steps at the beginning that do not count: maps and particles settle.
inline constexpr std::size_t kWarmUp = 2 * kTurn;

inline bool counts(std::size_t step) {
  return step >= kWarmUp && step % kTurn != 0;
}

/// A subject with its times of all steps.
struct Timed {
  Configuration configuration;
  std::unique_ptr<Subject> subject;
  experiments::StageClock wall;
  std::vector<double> cpu_ms;  ///< per step, of the calling thread [ms]
};

/// `steps` of each.
void run_interleaved(std::vector<Timed>& all, std::size_t steps);

}  // namespace benchmarks
