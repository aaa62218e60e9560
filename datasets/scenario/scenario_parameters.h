#pragma once
/// Every value of a scenario, once: name, unit, range, meaning (paper Sec. 4.1.1, 4.2.1). The table
/// that reading, checking, writing, `ldm parameters scenario` and docs/scenarios.md share.
#include <string>
#include <string_view>

#include "datasets/scenario/scenario.h"
#include "ldm/parameters.h"

namespace datasets {

inline constexpr std::string_view kPaperScenarios = "Sec. 4.1.1", kPaperFlight = "Sec. 4.2.1";

template <class Group, class Visitor>
void visit_group(Group& g, Visitor& visit) {
  const auto say = [&](std::string_view key, std::string_view unit, double min, double max,
                       std::string_view source, std::string_view help, auto& value,
                       const auto&... words) {
    const std::string name = "groups." + g.name + '.' + std::string(key);
    visit(ldm::ParameterInfo{name, "", unit, min, max, source, help}, value, words...);
  };
  constexpr std::string_view kA = kPaperScenarios, kB = kPaperFlight;
  say("count", "", 0, 1000, kA, "how many", g.count);
  say("shape", "", 0, 3, kA,
      "a person is torso, head and two legs that stand; a walker's legs swing", g.shape,
      kObstacleShapeNames);
  say("motion", "", 0, 2, kA,
      "static at a drawn place, shuttle to and fro along a drawn polyline, or by a timetable",
      g.motion, kObstacleMotionNames);
  say("width_m", "m", 0.05, 10, kA,
      "horizontal edges of a box, diameter of a cylinder, shoulders of a person", g.width);
  say("height_m", "m", 0.05, 10, kA, "height", g.height);
  say("bottom_m", "m", -10, 10, kA, "lowest point above z = 0", g.bottom);
  if (g.shape == ObstacleShape::kWalker) {
    say("stride_m", "m", 0.2, 3, kB, "walkers: way between two steps of the same foot", g.stride);
  }
  if (g.motion == ObstacleMotionKind::kStatic) return;
  if (g.motion == ObstacleMotionKind::kTimetable) {
    say("timetable_s_m", "s, m", -500, 500, kB, "timetable: stops [time, x, y]", g.timetable);
  } else {
    say("legs", "", 1, 100, kA, "shuttle: how many legs the polyline has", g.legs);
    say("leg_m", "m", 0.1, 1000, kA, "shuttle: length of a leg", g.leg);
    say("speed_mps", "m/s", 0.01, 20, kA, "shuttle: top speed, drawn for each pass of a leg",
        g.speed);
  }
  say("acceleration_mps2", "m/s^2", 0.01, 20, kA, "at both ends of each way", g.acceleration);
  if (g.motion == ObstacleMotionKind::kTimetable) {
    say("spread_m", "m", 0, 10, kB, "timetable: each place is moved by up to so much along x and y",
        g.spread);
    say("lateness_s", "s", 0, 60, kB, "timetable: each time is moved by up to so much, either way",
        g.lateness);
  } else {
    say("pause_s", "s", 0, 60, kA, "shuttle: rest at each corner", g.pause);
  }
}

template <class Flight, class Visitor>
void visit_flight(Flight& uav, Visitor& visit) {
  using Info = ldm::ParameterInfo;
  constexpr std::string_view kA = kPaperScenarios, kB = kPaperFlight;
  if (uav.kind == FlightKind::kTimetable) {
    visit(Info{"uav.timetable_s_m", "", "s, m", -500, 500, kB,
               "stops [time, x, y, z], in place of waypoints"},
          uav.timetable);
    visit(Info{"uav.spread_m", "", "m", 0, 10, kB,
               "timetable: the flight is moved by up to so much along each axis"},
          uav.spread);
    visit(Info{"uav.drift_m", "", "m", 0, 1, kB,
               "timetable: standard deviation of the path's control points, one a second"},
          uav.drift);
  } else {
    visit(Info{"uav.waypoints", "", "", 2, 10000, kA, "how many are drawn"}, uav.waypoints);
    visit(Info{"uav.leg_m", "", "m", 0, 1000, kA, "distance from one waypoint to the next"},
          uav.leg);
    visit(Info{"uav.height_m", "", "m", -100, 100, kA, "of the waypoints above z = 0"}, uav.height);
    visit(Info{"uav.max_speed_mps", "", "m/s", 0.1, 50, kA, "limit of the path through them"},
          uav.max_speed);
    visit(Info{"uav.max_acceleration_mps2", "", "m/s^2", 0.1, 50, kA, "the same"},
          uav.max_acceleration);
  }
  visit(Info{"uav.clearance_m", "", "m", 0, 10, kA,
             "least distance of the UAV's centre from an obstacle"},
        uav.clearance);
}

/// As `ldm::visit_parameters`; T is double, std::int64_t, Interval, a vector, a timetable or an
/// enumeration. Which values there are depends on the motions, shapes and flight of `s`.
/// @param s Scenario, const or not
template <class S, class Visitor>
void visit_parameters(S& s, Visitor&& visit) {
  using Info = ldm::ParameterInfo;
  constexpr std::string_view kA = kPaperScenarios;
  visit(Info{"frames", "", "", 1, 1000000, kA, "number of scans"}, s.frames);
  visit(Info{"area.size_m", "", "m", 1, 1000, kA,
             "x and y of the rectangle around the origin that holds all obstacles"},
        s.area);
  visit_flight(s.uav, visit);
  visit(Info{"sensor.channels", "", "", 1, 1024, kA, "of the LiDAR, spaced evenly in elevation"},
        s.sensor.channels);
  visit(Info{"sensor.elevation_deg", "", "deg", -90, 90, kA, "of the lowest and highest channel"},
        s.sensor.elevation);
  visit(Info{"sensor.azimuths", "", "", 4, 65536, kA, "firings a revolution"}, s.sensor.azimuths);
  visit(Info{"sensor.rate_hz", "", "Hz", 0.1, 1000, kA, "revolutions a second"}, s.sensor.rate);
  visit(Info{"sensor.range_m", "", "m", 0, 131.07, kA, "returns outside of it are lost"},
        s.sensor.range);
  visit(Info{"sensor.range_sigma_m", "", "m", 0, 10, kA, "standard deviation of the range noise"},
        s.sensor.range_sigma);
  visit(Info{"sensor.pose_sigma_m", "", "m", 0, 1, "assumed",
             "standard deviation of each scan's reported place, per axis; 0 where left out"},
        s.sensor.pose_sigma);
  visit(Info{"sensor.position_m", "", "m", -10, 10, "assumed", "on the UAV; 0 where left out"},
        s.sensor.position);
  visit(Info{"sensor.roll_pitch_yaw_deg", "", "deg", -180, 180, "assumed",
             "on the UAV; 0 where left out"},
        s.sensor.roll_pitch_yaw);
  visit(Info{"obstacles.gap_m", "", "m", 0, 100, kA,
             "least horizontal distance between two obstacles"},
        s.obstacle_gap);
  visit(Info{"obstacles.speed_scale", "", "", 0.01, 100, "assumed",
             "factor on all speeds of obstacles; accelerations grow with its square"},
        s.speed_scale);
  for (auto& group : s.groups) visit_group(group, visit);
}

}  // namespace datasets
