#include "experiments/avoidance/corridor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "datasets/files/text.h"
#include "datasets/random.h"

namespace experiments {
namespace {

using datasets::Leg;
using datasets::Obstacle;
using datasets::ObstacleGroup;
using datasets::ObstacleMotion;
using datasets::ObstacleMotionKind;
using datasets::Random;
using datasets::Scenario;

constexpr double kStep = 0.1;          ///< between checks of distances [s]
constexpr double kClearOfStart = 2.0;  ///< time in which nothing comes upon the start [s]
constexpr double kShortestWay = 1;     ///< from start to goal [m]
constexpr int kObstacleAttempts = 2000;
constexpr int kWorldAttempts = 20;

void check_corridor(const Scenario& scenario) {
  const auto refuse = [&](const std::string& what, const std::string& allowed) {
    throw ldm::InvalidInput("world " + scenario.name + ": " + what + ": allowed: " + allowed);
  };
  const bool has_goal =
      scenario.uav.kind == datasets::FlightKind::kTimetable && scenario.uav.timetable.size() >= 2;
  if (!has_goal) refuse("uav", "a timetable_s_m whose first and last stop are start and goal");
  for (const ObstacleGroup& group : scenario.groups) {
    if (group.motion == ObstacleMotionKind::kTimetable) {
      refuse("groups." + group.name + ".motion = timetable", "static, shuttle");
    }
  }
  const double way =
      (scenario.uav.timetable.back().place - scenario.uav.timetable.front().place).norm();
  if (way < kShortestWay) {
    refuse("uav.timetable_s_m: " + datasets::decimal(way) + " m from start to goal",
           "at least " + datasets::decimal(kShortestWay) + " m");
  }
}

Eigen::Vector2d draw_place(const Scenario& scenario, Random& random) {
  const double x = random.uniform(-scenario.area.x() / 2, scenario.area.x() / 2);
  return {x, random.uniform(-scenario.area.y() / 2, scenario.area.y() / 2)};
}

/// To and fro along a line, past a place in the area at a time of the flight.
ObstacleMotion draw_shuttle(const Scenario& scenario, const ObstacleGroup& group, Random& random) {
  const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  const double scale = scenario.speed_scale;
  Leg leg{.start = 0,
          .from = draw_place(scenario, random),
          .direction = {std::cos(heading), std::sin(heading)},
          .length = random.uniform(group.leg),
          .top_speed = random.uniform(group.speed) * scale,
          .acceleration = random.uniform(group.acceleration) * scale * scale,
          .pause = random.uniform(group.pause)};
  const double passes =
      random.uniform(scenario.uav.timetable.front().time, scenario.uav.timetable.back().time);
  const double into_leg = random.uniform(0, leg.travel_time());
  leg.from -= ObstacleMotion({leg}).at(into_leg).walked * leg.direction;
  // Legs before that one until the world begins, and after it until the world ends.
  const double period = leg.travel_time() + leg.pause;
  const auto before = static_cast<int>(std::ceil(std::max(0.0, passes - into_leg) / period));
  const auto turned = [](Leg l) {
    l.from += l.length * l.direction;
    l.direction = -l.direction;
    return l;
  };
  if (before % 2 != 0) leg = turned(leg);
  leg.start = passes - into_leg - before * period;
  std::vector<Leg> legs;
  for (; leg.start < scenario.duration(); leg.start += period, leg = turned(leg)) {
    legs.push_back(leg);
  }
  return ObstacleMotion(std::move(legs));
}

/// Where an obstacle is every kStep [m].
using Track = std::vector<Eigen::Vector2d>;

struct Placed {
  Obstacle obstacle;
  Track track;
};

Placed draw_obstacle(const Scenario& scenario, const ObstacleGroup& group, std::size_t id,
                     Random& random) {
  ObstacleMotion motion = group.motion == ObstacleMotionKind::kStatic
                              ? ObstacleMotion(draw_place(scenario, random),
                                               random.uniform(-std::numbers::pi, std::numbers::pi))
                              : draw_shuttle(scenario, group, random);
  Placed placed{{static_cast<std::int32_t>(id), draw_body(group, random),
                 random.uniform(group.bottom), std::move(motion)},
                {}};
  for (double t = 0; t <= scenario.duration(); t += kStep) {
    placed.track.push_back(placed.obstacle.motion.at(t).position);
  }
  return placed;
}

bool keep_apart(const Placed& a, const Placed& b, double gap) {
  // Two obstacles that approach one another are nearest half a step away from a sample.
  const double between =
      (a.obstacle.motion.top_speed() + b.obstacle.motion.top_speed()) * kStep / 2;
  const double least = a.obstacle.body.radius + b.obstacle.body.radius + gap + between;
  for (std::size_t i = 0; i < a.track.size(); ++i) {
    if ((a.track[i] - b.track[i]).squaredNorm() < least * least) return false;
  }
  return true;
}

/// Off the start at first, and what stands off the goal.
bool leaves_room(const Placed& placed, const Corridor& corridor, double clearance) {
  const double least = placed.obstacle.body.radius + clearance;
  const auto is_off = [&](const Eigen::Vector3d& place, double duration) {
    const auto samples = static_cast<std::ptrdiff_t>(duration / kStep);
    return std::all_of(
        placed.track.begin(), placed.track.begin() + samples,
        [&](const Eigen::Vector2d& p) { return (p - place.head<2>()).norm() >= least; });
  };
  return is_off(corridor.start, std::min(kClearOfStart, corridor.duration)) &&
         (!placed.obstacle.motion.is_static() || is_off(corridor.goal, kStep));
}

std::vector<Placed> place_all(const Scenario& scenario, const Corridor& corridor, Random& random) {
  std::vector<Placed> all;
  const auto fits = [&](const Placed& placed) {
    return leaves_room(placed, corridor, scenario.uav.clearance) &&
           std::all_of(all.begin(), all.end(), [&](const Placed& other) {
             return keep_apart(placed, other, scenario.obstacle_gap);
           });
  };
  for (const ObstacleGroup& group : scenario.groups) {
    for (std::int64_t i = 0; i < group.count; ++i) {
      int attempt = 0;
      Placed placed = draw_obstacle(scenario, group, all.size(), random);
      while (!fits(placed)) {
        if (++attempt == kObstacleAttempts) {
          throw std::runtime_error("no room for obstacle " + std::to_string(all.size() + 1) +
                                   " of group " + group.name);
        }
        placed = draw_obstacle(scenario, group, all.size(), random);
      }
      all.push_back(std::move(placed));
    }
  }
  return all;
}

}  // namespace

Corridor draw_corridor(const Scenario& scenario, std::uint64_t seed) {
  check(scenario);
  check_corridor(scenario);
  Corridor corridor{{},
                    scenario.uav.timetable.front().place,
                    scenario.uav.timetable.back().place,
                    scenario.duration()};
  std::string reason;
  for (std::uint64_t attempt = 0; attempt < kWorldAttempts; ++attempt) {
    Random random(datasets::random_bits(seed, attempt));
    try {
      for (Placed& placed : place_all(scenario, corridor, random)) {
        corridor.obstacles.push_back(std::move(placed.obstacle));
      }
      return corridor;
    } catch (const std::runtime_error& error) {
      reason = error.what();
    }
  }
  throw std::runtime_error("world " + scenario.name + ", seed " + std::to_string(seed) +
                           ": none in " + std::to_string(kWorldAttempts) +
                           " attempts; the last: " + reason);
}

}  // namespace experiments
