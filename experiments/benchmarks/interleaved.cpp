#include "experiments/benchmarks/interleaved.h"

#include <algorithm>
#include <ctime>

namespace benchmarks {
namespace {

double thread_cpu_ms() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

void step(Timed& timed, std::size_t k) {
  timed.subject->prepare(k);
  const double began = thread_cpu_ms();
  timed.wall.start_frame();
  timed.subject->step(k, timed.wall);
  timed.wall.end_frame();
  timed.cpu_ms.push_back(thread_cpu_ms() - began);
}

}  // namespace

void run_interleaved(std::vector<Timed>& all, std::size_t steps) {
  for (std::size_t turn = 0; turn < steps; turn += kTurn) {
    for (Timed& timed : all) {
      for (std::size_t k = turn; k < std::min(turn + kTurn, steps); ++k) step(timed, k);
    }
  }
}

}  // namespace benchmarks
