#include "datasets/scenario/scenario.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>

#include "datasets/files/toml_reader.h"
#include "datasets/hash.h"
#include "datasets/scenario/scenario_value.h"
#include "datasets/scenario/timetable.h"

namespace datasets {
namespace {

// Every value of a scenario stands once, in `visit_scenario`; setting, checking and writing are
// visitors of it. They are called with name, value and range, or with name, value and words.

template <class Group, class Visitor>
void visit_group(Group& g, Visitor& visit) {
  const std::string at = "groups." + g.name + '.';
  visit(at + "count", g.count, 0, 1000);
  visit(at + "shape", g.shape, kObstacleShapeNames);
  visit(at + "motion", g.motion, kObstacleMotionNames);
  visit(at + "width_m", g.width, 0.05, 10);
  visit(at + "height_m", g.height, 0.05, 10);
  visit(at + "bottom_m", g.bottom, -10, 10);
  if (g.shape == ObstacleShape::kWalker) visit(at + "stride_m", g.stride, 0.2, 3);
  if (g.motion == ObstacleMotionKind::kStatic) return;
  if (g.motion == ObstacleMotionKind::kTimetable) {
    visit(at + "timetable_s_m", g.timetable, -500, 500);
    visit(at + "acceleration_mps2", g.acceleration, 0.01, 20);
    visit(at + "spread_m", g.spread, 0, 10);
    visit(at + "lateness_s", g.lateness, 0, 60);
    return;
  }
  visit(at + "legs", g.legs, 1, 100);
  visit(at + "leg_m", g.leg, 0.1, 1000);
  visit(at + "speed_mps", g.speed, 0.01, 20);
  visit(at + "acceleration_mps2", g.acceleration, 0.01, 20);
  visit(at + "pause_s", g.pause, 0, 60);
}

template <class Flight, class Visitor>
void visit_flight(Flight& uav, Visitor& visit) {
  if (uav.kind == FlightKind::kTimetable) {
    visit("uav.timetable_s_m", uav.timetable, -500, 500);
    visit("uav.spread_m", uav.spread, 0, 10);
    visit("uav.drift_m", uav.drift, 0, 1);
  } else {
    visit("uav.waypoints", uav.waypoints, 2, 10000);
    visit("uav.leg_m", uav.leg, 0, 1000);
    visit("uav.height_m", uav.height, -100, 100);
    visit("uav.max_speed_mps", uav.max_speed, 0.1, 50);
    visit("uav.max_acceleration_mps2", uav.max_acceleration, 0.1, 50);
  }
  visit("uav.clearance_m", uav.clearance, 0, 10);
}

template <class S, class Visitor>
void visit_scenario(S& s, Visitor&& visit) {
  visit("frames", s.frames, 1, 1000000);
  visit("area.size_m", s.area, 1, 1000);
  visit_flight(s.uav, visit);
  visit("sensor.channels", s.sensor.channels, 1, 1024);
  visit("sensor.elevation_deg", s.sensor.elevation, -90, 90);
  visit("sensor.azimuths", s.sensor.azimuths, 4, 65536);
  visit("sensor.rate_hz", s.sensor.rate, 0.1, 1000);
  visit("sensor.range_m", s.sensor.range, 0, 131.07);
  visit("sensor.range_sigma_m", s.sensor.range_sigma, 0, 10);
  visit("sensor.position_m", s.sensor.position, -10, 10);
  visit("sensor.roll_pitch_yaw_deg", s.sensor.roll_pitch_yaw, -180, 180);
  visit("obstacles.gap_m", s.obstacle_gap, 0, 100);
  visit("obstacles.speed_scale", s.speed_scale, 0.01, 100);
  for (auto& group : s.groups) visit_group(group, visit);
}

/// Numbers separated by commas; empty if the text is anything else.
std::vector<double> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const char* at = text.data();; ++at) {
    const auto [end, error] =
        std::from_chars(at, text.data() + text.size(), numbers.emplace_back());
    if (error != std::errc()) return {};
    at = end;
    if (at == text.data() + text.size()) return numbers;
    if (*at != ',') return {};
  }
}

[[noreturn]] void reject(std::string_view name, std::string_view text, const std::string& allowed) {
  throw ldm::InvalidInput(std::string(name) + " = " + std::string(text) + ": allowed: " + allowed);
}

/// Sets the value of one name.
struct Setter {
  std::string_view name;
  std::string_view text;
  bool quoted = false;  ///< in quotes, the text is no number
  bool found = false;

  template <class T>
  void operator()(std::string_view field, T& value, double min, double max) {
    if (field != name) return;
    found = true;
    const std::vector<double> numbers = parse_numbers(text);
    if (quoted || !is_allowed<T>(numbers, min, max)) {
      reject(name, quoted ? '"' + std::string(text) + '"' : std::string(text),
             allowed_text<T>(min, max));
    }
    assign(numbers, value);
  }
  template <class Enum, std::size_t N>
  void operator()(std::string_view field, Enum& value, const std::string_view (&words)[N]) {
    if (field != name) return;
    found = true;
    const auto word = std::find(std::begin(words), std::end(words), text);
    if (word == std::end(words)) reject(name, text, one_of(words));
    value = static_cast<Enum>(word - std::begin(words));
  }
};

void set_value(Scenario& scenario, std::string_view name, std::string_view text, bool quoted) {
  Setter setter{name, text, quoted};
  visit_scenario(scenario, setter);
  if (!setter.found) reject(name, text, "a key that scenarios have");
}

/// Collects name and value of every field.
struct Writer {
  std::vector<std::pair<std::string, std::string>> values;

  template <class T>
  void operator()(std::string_view field, const T& value, double, double) {
    values.emplace_back(field, text_of(value));
  }
  template <class Enum, std::size_t N>
  void operator()(std::string_view field, Enum value, const std::string_view (&words)[N]) {
    values.emplace_back(field, words[static_cast<std::size_t>(value)]);
  }
};

/// Throws at the first value out of its range.
struct Checker {
  template <class T>
  void operator()(std::string_view field, const T& value, double min, double max) {
    if (is_allowed<T>(numbers_of(value), min, max)) return;
    reject(field, text_of(value), allowed_text<T>(min, max));
  }
  template <class Enum, std::size_t N>
  void operator()(std::string_view, Enum, const std::string_view (&)[N]) {}
};

bool may_be_missing(std::string_view name) {
  return name == "sensor.position_m" || name == "sensor.roll_pitch_yaw_deg";
}

/// A flight with a timetable has nothing else of the drawn ones.
FlightKind read_flight_kind(const TomlTable& file) {
  const bool listed = file.is_table("uav") && file.table("uav").has("timetable_s_m");
  return listed ? FlightKind::kTimetable : FlightKind::kWaypoints;
}

/// Groups with their kind of shape and motion, which decide what else is to be said of them.
std::vector<ObstacleGroup> read_groups(const TomlTable& file) {
  std::vector<ObstacleGroup> groups;
  const TomlTable table = file.table("groups");
  for (const std::string& name : table.keys()) {
    const TomlTable group = table.table(name);
    const bool plain = std::all_of(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    if (!plain) table.reject(name, "a name of letters, digits and _");
    groups.emplace_back().name = name;
    groups.back().shape = static_cast<ObstacleShape>(group.choice("shape", kObstacleShapeNames));
    groups.back().motion =
        static_cast<ObstacleMotionKind>(group.choice("motion", kObstacleMotionNames));
  }
  return groups;
}

/// Runs `action`; what it throws on bad input begins with that place then.
template <class Action>
void at_place(const std::string& place, Action action) {
  try {
    action();
  } catch (const ldm::InvalidInput& error) {
    throw ldm::InvalidInput(place + ": " + error.what());
  }
}

void set_from_leaf(Scenario& scenario, const TomlTable::Leaf& leaf) {
  at_place(leaf.place, [&] { set_value(scenario, leaf.name, leaf.value, leaf.is_text); });
}

/// That all stops can be reached in time.
void check_timetable(const ObstacleGroup& group) {
  if (group.motion != ObstacleMotionKind::kTimetable) return;
  const double needed = needed_acceleration(group);
  if (needed <= group.acceleration.min) return;
  const std::string at = "groups." + group.name + '.';
  if (std::isinf(needed)) {
    reject(at + "timetable_s_m", text_of(group.timetable),
           "stops more than twice lateness_s from one another");
  }
  reject(at + "acceleration_mps2", text_of(group.acceleration),
         "at least " + decimal(needed) + ", without which a stop may be reached too late");
}

}  // namespace

Scenario read_scenario(const std::filesystem::path& path) {
  const TomlTable file = TomlTable::open(path);
  Scenario scenario;
  scenario.name = path.stem().string();
  scenario.title = file.text("title");
  scenario.uav.kind = read_flight_kind(file);
  scenario.groups = read_groups(file);
  std::set<std::string> given;
  for (const TomlTable::Leaf& leaf : file.leaves()) {
    if (leaf.name == "title") continue;
    set_from_leaf(scenario, leaf);
    given.insert(leaf.name);
  }
  for (const auto& [name, value] : scenario_values(scenario)) {
    if (given.contains(name) || may_be_missing(name)) continue;
    // No text is a value of anything: the setter says what would be.
    set_from_leaf(scenario, {name, "", file.place() + ": missing", false});
  }
  for (const ObstacleGroup& group : scenario.groups) {
    at_place(file.table("groups").table(group.name).place("acceleration_mps2"),
             [&] { check_timetable(group); });
  }
  return scenario;
}

void set_scenario_value(Scenario& scenario, std::string_view name, std::string_view text) {
  Scenario changed = scenario;
  set_value(changed, name, text, false);
  check(changed);
  scenario = std::move(changed);
}

void check(const Scenario& scenario) {
  visit_scenario(scenario, Checker());
  for (const ObstacleGroup& group : scenario.groups) check_timetable(group);
}

std::vector<std::pair<std::string, std::string>> scenario_values(const Scenario& scenario) {
  Writer writer;
  visit_scenario(scenario, writer);
  return std::move(writer.values);
}

std::string scenario_hash(const Scenario& scenario) {
  Fnv1a fnv;
  for (const auto& [name, value] : scenario_values(scenario)) {
    fnv.add(name);
    fnv.add("=");
    fnv.add(value);
    fnv.add("\n");
  }
  return hex(fnv.value());
}

}  // namespace datasets
