#pragma once
/// Processor time of the calling thread: what else the machine does hardly counts (closed loop).
#include <ctime>

namespace experiments {

/// [ms]
inline double thread_time_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Runs `action`; its processor time [ms].
template <class Action>
double thread_time_of(Action action) {
  const double begin = thread_time_ms();
  action();
  return thread_time_ms() - begin;
}

}  // namespace experiments
