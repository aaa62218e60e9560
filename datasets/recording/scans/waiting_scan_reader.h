#pragma once
/// Recordings in which the poses of a scan may stand behind it (no paper section).
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// Reads on until the poses of the first scan that waits are known, the recording ends, or so many
/// scans wait that they never will be. `Waiting` is a scan as it was read, with its `place` for
/// messages.
template <class Waiting>
class WaitingScanReader : public ScanReader {
 public:
  bool next(Frame& frame) final {
    while (!may_take_one()) read_on();
    if (waiting_.empty()) {
      if (damage_) std::rethrow_exception(std::exchange(damage_, nullptr));
      return false;
    }
    Waiting scan = std::move(waiting_.front());
    waiting_.pop_front();
    place_ = scan.place;
    frame.index = frames_++;
    frame.truth.reset();
    take(scan, frame.scan);
    return true;
  }
  std::optional<std::int64_t> size() const final { return {}; }
  std::string place() const final { return place_; }

 protected:
  /// Reads one piece of the recording: calls `wait` with a scan, or `end`.
  virtual void read_on() = 0;
  /// True if nothing that is read later changes the poses of a scan.
  virtual bool covers(const Waiting& waiting) const = 0;
  /// @throws BrokenFrame if the scan or its poses cannot be used
  virtual void take(Waiting& waiting, ldm::Scan& scan) = 0;

  void wait(Waiting waiting) { waiting_.push_back(std::move(waiting)); }
  /// `damage` is thrown once, after the scans that still wait.
  void end(std::exception_ptr damage = nullptr) {
    ended_ = true;
    damage_ = std::move(damage);
  }
  bool ended() const { return ended_; }

 private:
  bool may_take_one() const {
    constexpr std::size_t kMostWaiting = 64;
    if (ended_) return true;
    if (waiting_.empty()) return false;
    return waiting_.size() >= kMostWaiting || covers(waiting_.front());
  }

  std::deque<Waiting> waiting_;
  bool ended_ = false;
  std::exception_ptr damage_;
  std::int64_t frames_ = 0;
  std::string place_;
};

/// When the last point of a scan was measured [s].
inline double end_of(double time, const std::vector<float>& delays) {
  if (delays.empty()) return time;
  return time + std::max(0.0, static_cast<double>(*std::max_element(delays.begin(), delays.end())));
}

}  // namespace datasets
