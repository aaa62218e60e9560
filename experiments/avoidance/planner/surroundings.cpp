#include "experiments/avoidance/planner/surroundings.h"

#include <cmath>

namespace experiments {

Distance box_distance(const Eigen::Vector3d& offset, const Eigen::Vector3d& half_size) {
  const Eigen::Vector3d beyond = offset.cwiseAbs() - half_size;
  const auto signed_like_offset = [&](int axis, double value) {
    return offset[axis] < 0 ? -value : value;
  };
  int axis = 0;
  const double deepest = beyond.maxCoeff(&axis);
  Distance distance{deepest, Eigen::Vector3d::Zero()};
  if (deepest <= 0) {
    distance.gradient[axis] = signed_like_offset(axis, 1);
    return distance;
  }
  const Eigen::Vector3d outside = beyond.cwiseMax(0);
  distance.value = outside.norm();
  for (int i = 0; i < 3; ++i) {
    distance.gradient[i] = signed_like_offset(i, outside[i] / distance.value);
  }
  return distance;
}

Distance Surroundings::from_still(const Eigen::Vector3d& p) const {
  Distance distance = still.at(p);
  distance.value -= margin;
  return distance;
}

Distance Surroundings::from_moving(std::size_t sample, const Eigen::Vector3d& p) const {
  Distance nearest{kReach, Eigen::Vector3d::Zero()};
  for (const Mover& mover : movers) {
    Distance distance = box_distance(p - mover.centre[sample], mover.half_size);
    distance.value -= mover.doubt[sample] + margin;
    if (distance.value < nearest.value) nearest = distance;
  }
  return nearest;
}

}  // namespace experiments
