#pragma once
/// Ctrl-C as a request to end in order (no paper section).

namespace experiments {

/// While one lives, the first SIGINT, SIGTERM or SIGHUP sets `requested`; another one, two seconds
/// later or more, ends the program at once, as without it. One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool requested() const;
};

}  // namespace experiments
