#include "datasets/scenario/timetable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace datasets {
namespace {

/// The timetable as one obstacle keeps it: stops at the same place stay at the same place.
std::vector<Stop<2>> drawn_timetable(const ObstacleGroup& group, double speed_scale,
                                     Random& random) {
  std::vector<Stop<2>> drawn;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < group.timetable.size(); ++i) {
    const Stop<2>& stop = group.timetable[i];
    if (i == 0 || stop.place != group.timetable[i - 1].place) {
      offset.x() = random.uniform(-group.spread, group.spread);
      offset.y() = random.uniform(-group.spread, group.spread);
    }
    const double time = stop.time + random.uniform(-group.lateness, group.lateness);
    drawn.push_back({time / speed_scale, stop.place + offset});
  }
  return drawn;
}

/// The speed at which a way of that length takes that time, speeding up and braking included.
double top_speed(double length, double time, double acceleration) {
  const double ramps = acceleration * time;
  return (ramps - std::sqrt(std::max(0.0, ramps * ramps - 4 * acceleration * length))) / 2;
}

}  // namespace

ObstacleMotion draw_timetable_motion(const ObstacleGroup& group, double speed_scale,
                                     Random& random) {
  const std::vector<Stop<2>> stops = drawn_timetable(group, speed_scale, random);
  const double acceleration = random.uniform(group.acceleration) * speed_scale * speed_scale;
  std::vector<Leg> legs;
  double end = 0;  // of the leg before
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const Eigen::Vector2d way = stops[i + 1].place - stops[i].place;
    if (way.isZero(0)) continue;
    const double time = stops[i + 1].time - stops[i].time;
    if (!legs.empty()) legs.back().pause = stops[i].time - end;
    legs.push_back({stops[i].time, stops[i].place, way.normalized(), way.norm(),
                    top_speed(way.norm(), time, acceleration), acceleration, 0});
    end = stops[i + 1].time;
  }
  if (!legs.empty()) return ObstacleMotion(std::move(legs));
  return {stops.front().place, random.uniform(-std::numbers::pi, std::numbers::pi)};
}

double needed_acceleration(const ObstacleGroup& group) {
  double needed = 0;
  for (std::size_t i = 0; i + 1 < group.timetable.size(); ++i) {
    const Stop<2>&from = group.timetable[i], &to = group.timetable[i + 1];
    const double least_time = to.time - from.time - 2 * group.lateness;
    if (least_time <= 0) return std::numeric_limits<double>::infinity();
    if (from.place == to.place) continue;
    const double longest = (to.place - from.place).norm() + 2 * std::numbers::sqrt2 * group.spread;
    needed = std::max(needed, 4 * longest / (least_time * least_time));
  }
  return needed;
}

Eigen::Vector3d place_at(const std::vector<Stop<3>>& timetable, double t) {
  const auto after = std::upper_bound(timetable.begin(), timetable.end(), t,
                                      [](double time, const Stop<3>& s) { return time < s.time; });
  if (after == timetable.begin()) return after->place;
  if (after == timetable.end()) return timetable.back().place;
  const Stop<3>& before = *(after - 1);
  const double share = (t - before.time) / (after->time - before.time);
  return before.place + share * (after->place - before.place);
}

}  // namespace datasets
