#include "experiments/metrics/ghost_score.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace experiments {

void GhostTally::add(double time, const ldm::LocalMap& map, const TruthGrid& truth) {
  ++frames_;
  time_ = time;
  std::copy_if(held_.begin(), held_.end(), std::back_inserter(left_), [&](const LeftOver& held) {
    return map.window.contains(held.voxel) && !truth.solid(held.voxel);
  });
  std::erase_if(left_, [&](const LeftOver& left) { return ends(left, map, truth); });
  for (const LeftOver& left : left_) ghosts_ += truth.objects_near(left.voxel).count == 0;
  held_.clear();
  for (const ldm::VoxelIndex& v : truth.moving()) {
    if (ldm::is_occupied(map.occupancy[map.window.index(v)])) held_.push_back({v, time});
  }
}

bool GhostTally::ends(const LeftOver& left, const ldm::LocalMap& map, const TruthGrid& truth) {
  if (!map.window.contains(left.voxel) || truth.solid(left.voxel)) {
    ++ends_of(left).lost;
    return true;
  }
  if (ldm::is_occupied(map.occupancy[map.window.index(left.voxel)])) return false;
  ++ends_of(left).cleared;
  return true;
}

GhostTally::Ends& GhostTally::ends_of(const LeftOver& left) {
  return ends_[std::llround(1000 * (time_ - left.held))];
}

void GhostTally::finish() {
  for (const LeftOver& left : left_) ++ends_of(left).lost;
  left_.clear();
}

std::optional<double> GhostTally::time_to_clear() const {
  std::int64_t left = 0;
  for (const auto& [age, ends] : ends_) left += ends.cleared + ends.lost;
  double remaining = 1;  // share
  for (const auto& [age, ends] : ends_) {
    remaining *= 1 - static_cast<double>(ends.cleared) / static_cast<double>(left);
    constexpr double kRounding = 1e-9;
    if (ends.cleared > 0 && remaining <= 1 - kCleared + kRounding) {
      return static_cast<double>(age) / 1000;
    }
    left -= ends.cleared + ends.lost;
  }
  return {};
}

}  // namespace experiments
