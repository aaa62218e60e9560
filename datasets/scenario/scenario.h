#pragma once
/// The description of a simulated scenario: obstacles, flight and sensor (paper Sec. 4.1.1, Fig.
/// 5; Sec. 4.2.1, Fig. 11).
///
/// A seed draws a world from it. The world has no ground: the paper ignores ground returns. The
/// form of the file: docs/scenarios.md.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/random.h"
#include "ldm/types.h"

namespace datasets {

/// A walker is a person whose legs swing.
enum class ObstacleShape { kBox, kCylinder, kPerson, kWalker };
inline constexpr std::string_view kObstacleShapeNames[] = {"box", "cylinder", "person", "walker"};

enum class ObstacleMotionKind { kStatic, kShuttle, kTimetable };
inline constexpr std::string_view kObstacleMotionNames[] = {"static", "shuttle", "timetable"};

/// When to be where.
template <int N>
struct Stop {
  double time = 0;                                                          ///< [s]
  Eigen::Matrix<double, N, 1> place = Eigen::Matrix<double, N, 1>::Zero();  ///< world [m]
};

/// Obstacles drawn alike. A shuttle goes along a polyline, stops at each corner, and goes back.
/// With a timetable, an obstacle goes from stop to stop, and rests between two at the same place.
struct ObstacleGroup {
  std::string name;
  std::int64_t count = 0;
  ObstacleShape shape = ObstacleShape::kBox;
  ObstacleMotionKind motion = ObstacleMotionKind::kStatic;
  Interval width;         ///< box: both horizontal edges; cylinder: diameter; person: shoulders [m]
  Interval height;        ///< [m]
  Interval bottom;        ///< lowest point above z = 0 [m]
  Interval legs;          ///< number of legs of the polyline, rounded; shuttles only
  Interval leg;           ///< length of a leg [m]; shuttles only
  Interval speed;         ///< top speed, drawn anew for each pass of a leg [m/s]; shuttles only
  Interval acceleration;  ///< at the start and the end of each leg [m/s^2]; what moves
  Interval pause;         ///< at each corner [s]; shuttles only
  Interval stride;        ///< way between two steps of the same foot [m]; walkers only
  std::vector<Stop<2>> timetable = {};  ///< as all below, of what has one
  double spread = 0;                    ///< each place is moved by up to so much along x and y [m]
  double lateness = 0;                  ///< each time is moved by up to so much, either way [s]
};

struct SensorDescription {
  std::int64_t channels = 16;
  Interval elevation;  ///< of the lowest and the highest channel [deg]
  std::int64_t azimuths = 1024;
  double rate = 10;                                          ///< [Hz]
  Interval range;                                            ///< returns outside it are lost [m]
  double range_sigma = 0;                                    ///< [m]
  double pose_sigma = 0;                                     ///< of the reported pose [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();        ///< in the UAV's frame [m]
  Eigen::Vector3d roll_pitch_yaw = Eigen::Vector3d::Zero();  ///< in the UAV's frame [deg]
};

/// Among drawn waypoints, or by a timetable: hovering where two stops have the same place.
enum class FlightKind { kWaypoints, kTimetable };

struct FlightDescription {
  FlightKind kind = FlightKind::kWaypoints;
  std::int64_t waypoints = 2;   ///< as all up to max_acceleration, of a flight among waypoints
  Interval leg;                 ///< distance between successive waypoints [m]
  Interval height;              ///< of the waypoints above z = 0 [m]
  double max_speed = 0;         ///< [m/s]
  double max_acceleration = 0;  ///< [m/s^2]
  double clearance = 0;         ///< least distance of the UAV's centre from an obstacle [m]
  std::vector<Stop<3>> timetable = {};  ///< as all below, of a flight by timetable
  double spread = 0;  ///< the flight is moved by up to so much along each axis [m]
  double drift = 0;   ///< standard deviation of the path's control points, one a second [m]
};

struct Scenario {
  std::string name;   ///< stem of its file
  std::string title;  ///< one line
  std::int64_t frames = 0;
  Eigen::Vector2d area{0, 0};  ///< edges of the rectangle around the origin that holds all [m]
  double obstacle_gap = 0;     ///< least horizontal distance between obstacles [m]
  double speed_scale = 1;      ///< factor on all speeds; accelerations grow with its square
  SensorDescription sensor;
  FlightDescription uav;
  std::vector<ObstacleGroup> groups;  ///< in the order of the file

  double duration() const { return static_cast<double>(frames) / sensor.rate; }  ///< [s]
};

/// @throws ldm::InvalidInput with file, line, key, value and what is allowed.
Scenario read_scenario(const std::filesystem::path& file);

/// @throws ldm::InvalidInput naming the first value out of its range.
void check(const Scenario& scenario);

/// Set one value by its name in the file, from text: `sensor.channels` "32",
/// `groups.persons.speed_mps` "0.3,1.5", `obstacles.speed_scale` "2".
/// @throws ldm::InvalidInput naming value, text and what is allowed; nothing is changed.
void set_scenario_value(Scenario& scenario, std::string_view name, std::string_view text);

/// The complete description: name and value as text of everything that decides what a seed draws.
std::vector<std::pair<std::string, std::string>> scenario_values(const Scenario& scenario);

/// 64-bit FNV-1a of `scenario_values` in hexadecimal: equal hash and seed, equal frames.
std::string scenario_hash(const Scenario& scenario);

}  // namespace datasets
