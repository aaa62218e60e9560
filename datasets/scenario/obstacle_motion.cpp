#include "datasets/scenario/obstacle_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "datasets/scenario/timetable.h"

namespace datasets {
namespace {

double azimuth(const Eigen::Vector2d& direction) {
  return std::atan2(direction.y(), direction.x());
}

/// Between two headings [rad], the short way round; `share` 0..1.
double turned(double from, double to, double share) {
  return from + share * std::remainder(to - from, 2 * std::numbers::pi);
}

Eigen::Vector2d draw_point(const Eigen::Vector2d& area, Random& random) {
  const double x = random.uniform(-area.x() / 2, area.x() / 2);
  const double y = random.uniform(-area.y() / 2, area.y() / 2);
  return {x, y};
}

std::vector<Eigen::Vector2d> draw_polyline(const ObstacleGroup& group, const Eigen::Vector2d& area,
                                           Random& random) {
  std::vector<Eigen::Vector2d> corners = {draw_point(area, random)};
  const auto legs = std::lround(random.uniform(group.legs));
  double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  for (long leg = 0; leg < legs; ++leg) {
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    corners.push_back(corners.back() + random.uniform(group.leg) * direction);
    // Corners of up to a right angle: a sharper turn is what the way back is for.
    heading += random.uniform(-std::numbers::pi / 2, std::numbers::pi / 2);
  }
  return corners;
}

}  // namespace

double Leg::ramp_time() const {
  return std::min(top_speed / acceleration, std::sqrt(length / acceleration));
}

double Leg::travel_time() const {
  // Each ramp covers half of what its time covers at full speed.
  const double speed = acceleration * ramp_time();
  return length / speed + ramp_time();
}

ObstacleMotion::ObstacleMotion(const Eigen::Vector2d& position, double heading) {
  rest_.position = position;
  rest_.heading = heading;
}

ObstacleMotion::ObstacleMotion(std::vector<Leg> legs) : legs_(std::move(legs)) {}

MotionState ObstacleMotion::at(double t) const {
  if (legs_.empty()) return rest_;
  const auto after = std::upper_bound(legs_.begin(), legs_.end(), t,
                                      [](double time, const Leg& leg) { return time < leg.start; });
  const Leg& leg = after == legs_.begin() ? *after : *(after - 1);
  const double ramp = leg.ramp_time(), travel = leg.travel_time();
  const double elapsed = std::clamp(t - leg.start, 0.0, travel);
  const double remaining = travel - elapsed;

  double along = 0, speed = 0, acceleration = 0;
  if (elapsed < ramp) {
    along = leg.acceleration * elapsed * elapsed / 2;
    speed = leg.acceleration * elapsed;
    acceleration = t < leg.start ? 0 : leg.acceleration;
  } else if (remaining < ramp) {
    along = leg.length - leg.acceleration * remaining * remaining / 2;
    speed = leg.acceleration * remaining;
    acceleration = remaining > 0 ? -leg.acceleration : 0;
  } else {
    speed = leg.acceleration * ramp;
    along = speed * (elapsed - ramp / 2);
  }

  MotionState state{leg.from + along * leg.direction,
                    speed * leg.direction,
                    acceleration * leg.direction,
                    azimuth(leg.direction),
                    along,
                    speed / (leg.acceleration * ramp)};
  const double rested = t - leg.start - travel;
  if (rested > 0 && after != legs_.end()) {
    state.heading = turned(state.heading, azimuth(after->direction), rested / leg.pause);
  }
  return state;
}

double ObstacleMotion::top_speed() const {
  double fastest = 0;
  for (const Leg& leg : legs_) fastest = std::max(fastest, leg.acceleration * leg.ramp_time());
  return fastest;
}

ObstacleMotion draw_motion(const ObstacleGroup& group, const Eigen::Vector2d& area,
                           double speed_scale, double duration, Random& random) {
  if (group.motion == ObstacleMotionKind::kStatic) {
    const Eigen::Vector2d position = draw_point(area, random);
    return {position, random.uniform(-std::numbers::pi, std::numbers::pi)};
  }
  if (group.motion == ObstacleMotionKind::kTimetable) {
    return draw_timetable_motion(group, speed_scale, random);
  }
  const std::vector<Eigen::Vector2d> corners = draw_polyline(group, area, random);
  const double acceleration = random.uniform(group.acceleration) * speed_scale * speed_scale;
  std::vector<Leg> legs;
  double time = 0;
  std::size_t corner = 0;
  for (bool forward = true; time < duration;) {
    if (corner == 0) forward = true;
    if (corner + 1 == corners.size()) forward = false;
    const std::size_t next = forward ? corner + 1 : corner - 1;
    const Eigen::Vector2d way = corners[next] - corners[corner];
    legs.push_back({time, corners[corner], way.normalized(), way.norm(),
                    random.uniform(group.speed) * speed_scale, acceleration,
                    random.uniform(group.pause)});
    // The log begins at some moment of the first leg.
    if (legs.size() == 1) legs[0].start = time = -random.uniform(0, legs[0].travel_time());
    time += legs.back().travel_time() + legs.back().pause;
    corner = next;
  }
  return ObstacleMotion(std::move(legs));
}

}  // namespace datasets
