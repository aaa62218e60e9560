#include "datasets/scenario/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "datasets/scenario/scripted_flight.h"

namespace datasets {
namespace {

constexpr double kStep = 0.1;  ///< between checks of distances [s]
constexpr int kObstacleAttempts = 2000;
constexpr int kWaypointAttempts = 1000;
constexpr int kWorldAttempts = 20;

/// Where an obstacle is over the log, one position per kStep [m].
using Track = std::vector<Eigen::Vector2d>;

Track track_of(const ObstacleMotion& motion, double duration) {
  Track track(static_cast<std::size_t>(std::floor(duration / kStep + 1e-9)) + 1);
  for (std::size_t i = 0; i < track.size(); ++i) {
    track[i] = motion.at(static_cast<double>(i) * kStep).position;
  }
  return track;
}

struct Placed {
  Obstacle obstacle;
  Track track;
  double speed = 0;  ///< never exceeded [m/s]
};

bool stays_inside(const Placed& placed, const Eigen::Vector2d& area) {
  const Eigen::Array2d most = area.array() / 2 - placed.obstacle.body.radius;
  return std::all_of(placed.track.begin(), placed.track.end(),
                     [&](const auto& p) { return (p.array().abs() <= most).all(); });
}

/// At every time, not only where the tracks are sampled: two obstacles that approach one another
/// from sample to sample are nearest half a step away from one.
bool keep_apart(const Placed& a, const Placed& b, double gap) {
  const double least =
      a.obstacle.body.radius + b.obstacle.body.radius + gap + (a.speed + b.speed) * kStep / 2;
  for (std::size_t i = 0; i < a.track.size(); ++i) {
    if ((a.track[i] - b.track[i]).squaredNorm() < least * least) return false;
  }
  return true;
}

/// Of a shuttle the fastest that could have been drawn.
double speed_bound(const Scenario& scenario, const ObstacleGroup& group,
                   const ObstacleMotion& motion) {
  if (group.motion == ObstacleMotionKind::kTimetable) return motion.top_speed();
  return group.speed.max * scenario.speed_scale;
}

/// One that stays inside the area and off all others.
Placed place(const Scenario& scenario, const ObstacleGroup& group,
             const std::vector<Placed>& others, Random& random) {
  for (int attempt = 0; attempt < kObstacleAttempts; ++attempt) {
    ObstacleMotion motion =
        draw_motion(group, scenario.area, scenario.speed_scale, scenario.duration(), random);
    Track track = track_of(motion, scenario.duration());
    const double speed = speed_bound(scenario, group, motion);
    Placed placed{{static_cast<std::int32_t>(others.size()), draw_body(group, random),
                   random.uniform(group.bottom), std::move(motion)},
                  std::move(track),
                  speed};
    const bool apart = std::all_of(others.begin(), others.end(), [&](const Placed& other) {
      return keep_apart(placed, other, scenario.obstacle_gap);
    });
    if (apart && stays_inside(placed, scenario.area)) return placed;
  }
  throw std::runtime_error("no room for obstacle " + std::to_string(others.size() + 1) +
                           " of group " + group.name);
}

std::vector<Placed> place_all(const Scenario& scenario, Random& random) {
  std::vector<Placed> placed;
  for (const ObstacleGroup& group : scenario.groups) {
    for (std::int64_t i = 0; i < group.count; ++i) {
      placed.push_back(place(scenario, group, placed, random));
    }
  }
  return placed;
}

KeepOut keep_out(const Placed& placed) {
  const Obstacle& obstacle = placed.obstacle;
  return {obstacle.body.radius, obstacle.bottom, obstacle.bottom + obstacle.body.height,
          placed.track};
}

/// Moving obstacles give way in time; the ones at rest must leave room at each waypoint.
bool is_free(const Eigen::Vector3d& waypoint, const std::vector<Placed>& placed, double clearance) {
  return std::none_of(placed.begin(), placed.end(), [&](const Placed& p) {
    return p.obstacle.motion.is_static() &&
           (p.track[0] - waypoint.head<2>()).norm() < p.obstacle.body.radius + clearance;
  });
}

std::vector<Eigen::Vector3d> draw_waypoints(const Scenario& scenario,
                                            const std::vector<Placed>& placed, Random& random) {
  const FlightDescription& uav = scenario.uav;
  std::vector<Eigen::Vector3d> waypoints;
  for (int attempt = 0; attempt < kWaypointAttempts; ++attempt) {
    const double x = random.uniform(-scenario.area.x() / 2, scenario.area.x() / 2);
    const double y = random.uniform(-scenario.area.y() / 2, scenario.area.y() / 2);
    const Eigen::Vector3d point(x, y, random.uniform(uav.height));
    if (!is_free(point, placed, uav.clearance)) continue;
    if (!waypoints.empty()) {
      const double leg = (point - waypoints.back()).norm();
      if (leg < uav.leg.min || leg > uav.leg.max) continue;
    }
    waypoints.push_back(point);
    if (static_cast<std::int64_t>(waypoints.size()) == uav.waypoints) return waypoints;
    attempt = 0;
  }
  throw std::runtime_error("no room for waypoint " + std::to_string(waypoints.size() + 1));
}

FlightPath draw_path(const Scenario& scenario, const std::vector<Placed>& placed, Random& random) {
  FlightTask task;
  for (const Placed& p : placed) task.keep_outs.push_back(keep_out(p));
  if (scenario.uav.kind == FlightKind::kTimetable) {
    return draw_scripted_flight(scenario.uav, scenario.duration(), task.keep_outs, kStep, random);
  }
  task.waypoints = draw_waypoints(scenario, placed, random);
  task.duration = scenario.duration();
  task.sample_step = kStep;
  task.max_speed = scenario.uav.max_speed;
  task.max_acceleration = scenario.uav.max_acceleration;
  task.clearance = scenario.uav.clearance;
  return fit_flight_path(task);
}

World draw_once(const Scenario& scenario, Random& random) {
  std::vector<Placed> placed = place_all(scenario, random);
  World world{{}, draw_path(scenario, placed, random)};
  for (Placed& p : placed) world.obstacles.push_back(std::move(p.obstacle));
  return world;
}

}  // namespace

World draw_world(const Scenario& scenario, std::uint64_t seed) {
  std::string reason;
  for (std::uint64_t attempt = 0; attempt < kWorldAttempts; ++attempt) {
    Random random(random_bits(seed, attempt));
    try {
      return draw_once(scenario, random);
    } catch (const std::runtime_error& error) {
      reason = error.what();
    }
  }
  throw std::runtime_error("scenario " + scenario.name + ", seed " + std::to_string(seed) +
                           ": no world in " + std::to_string(kWorldAttempts) +
                           " attempts; the last: " + reason);
}

}  // namespace datasets
