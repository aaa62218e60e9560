#include "datasets/input_counts.h"

namespace datasets {
namespace {

std::int64_t sum_of(const InputCounts::ByReason& counts) {
  std::int64_t sum = 0;
  for (const auto& [reason, count] : counts) sum += count;
  return sum;
}

/// `2 broken scan, 1 no pose`
std::string listed(const InputCounts::ByReason& counts) {
  std::string text;
  for (const auto& [reason, count] : counts) {
    if (!text.empty()) text += ", ";
    text.append(std::to_string(count)).append(" ").append(reason);
  }
  return text;
}

}  // namespace

std::int64_t InputCounts::skipped() const {
  return sum_of(frames_skipped);
}

std::string InputCounts::skipped_text() const {
  return std::to_string(skipped()) + " frames skipped: " + listed(frames_skipped);
}

std::vector<std::string> InputCounts::losses(std::int64_t frames, std::int64_t points) const {
  std::vector<std::string> lines;
  if (skipped() > 0) lines.push_back(skipped_text());
  for (const auto& [sensor, count] : other_sensors) {
    lines.push_back(std::to_string(count) + " scans of another sensor left out: " + sensor);
  }
  if (points == 0 && sum_of(points_dropped) > 0) {
    lines.push_back("no point was used: " + listed(points_dropped));
  }
  const auto no_ground = other.find(kNoGround);
  if (frames > 0 && no_ground != other.end() && no_ground->second == frames) {
    lines.push_back("no ground was found in any frame: all points were used");
  }
  return lines;
}

}  // namespace datasets
