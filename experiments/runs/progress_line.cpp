#include "experiments/runs/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace experiments {

ProgressLine::ProgressLine(std::optional<std::int64_t> total)
    : total_(total), terminal_(isatty(STDERR_FILENO) == 1), began_(Clock::now()), last_(began_) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputc('\n', stderr);
}

void ProgressLine::show(std::int64_t frames, const std::string& detail) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  const bool last = total_ && frames == *total_;
  if (now - last_ < std::chrono::milliseconds(200) && !last) return;
  last_ = now;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - began_).count();
  std::string count = std::to_string(frames);
  if (total_) count.append("/").append(std::to_string(*total_));
  std::fprintf(stderr, "\rframe %s  %.1f frames/s%s  %s\033[K", count.c_str(),
               static_cast<double>(frames) / seconds, time_left(frames, seconds).c_str(),
               detail.c_str());
}

std::string ProgressLine::time_left(std::int64_t frames, double seconds) const {
  if (!total_) return {};
  const double left = seconds * static_cast<double>(*total_ - frames) /
                      static_cast<double>(std::max<std::int64_t>(frames, 1));
  char text[40];
  std::snprintf(text, sizeof text, "  %d:%02d left", static_cast<int>(left) / 60,
                static_cast<int>(left) % 60);
  return text;
}

}  // namespace experiments
