#include "experiments/runs/interruption.h"

#include <csignal>
#include <ctime>

namespace experiments {
namespace {

// A signal handler reaches no other objects.
volatile std::sig_atomic_t g_requested = 0;
volatile std::time_t g_second = 0;  // of the first request

std::time_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec;
}

void set_handler(void (*handler)(int)) {
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
  std::signal(SIGHUP, handler);  // the terminal was closed
}

/// Some programs, `timeout` for one, signal both a process and its group: one request.
void request(int signal) {
  if (g_requested == 0) {
    g_second = now();
    g_requested = 1;
  } else if (now() - g_second > 1) {
    set_handler(SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

Interruption::Interruption() {
  g_requested = 0;
  set_handler(request);
}

Interruption::~Interruption() {
  set_handler(SIG_DFL);
}

bool Interruption::requested() const {
  return g_requested != 0;
}

}  // namespace experiments
