#pragma once
/// The mean of numbers that come one by one (no paper section).
#include <cstdint>
#include <optional>

namespace experiments {

/// Mean of what was added; none of nothing.
class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  std::int64_t count() const { return count_; }
  std::optional<double> value() const {
    return count_ > 0 ? std::optional(sum_ / static_cast<double>(count_)) : std::nullopt;
  }

 private:
  double sum_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace experiments
