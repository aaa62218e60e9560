#include "datasets/scenario.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <set>
#include <type_traits>

#include "datasets/toml_node.h"
#include "datasets/toml_reader.h"

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
  if (g.motion == ObstacleMotionKind::kStatic) return;
  visit(at + "legs", g.legs, 1, 100);
  visit(at + "leg_m", g.leg, 0.1, 1000);
  visit(at + "speed_mps", g.speed, 0.01, 20);
  visit(at + "acceleration_mps2", g.acceleration, 0.01, 20);
  visit(at + "pause_s", g.pause, 0, 60);
}

template <class S, class Visitor>
void visit_scenario(S& s, Visitor&& visit) {
  visit("frames", s.frames, 1, 1000000);
  visit("area.size_m", s.area, 1, 1000);
  visit("uav.waypoints", s.uav.waypoints, 2, 10000);
  visit("uav.leg_m", s.uav.leg, 0, 1000);
  visit("uav.height_m", s.uav.height, -100, 100);
  visit("uav.max_speed_mps", s.uav.max_speed, 0.1, 50);
  visit("uav.max_acceleration_mps2", s.uav.max_acceleration, 0.1, 50);
  visit("uav.clearance_m", s.uav.clearance, 0, 10);
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

// A value as numbers, and back.
template <class T>
inline constexpr std::size_t kSize = 1;
template <>
inline constexpr std::size_t kSize<Interval> = 2;
template <int N>
inline constexpr std::size_t kSize<Eigen::Matrix<double, N, 1>> = N;

std::vector<double> numbers_of(double value) {
  return {value};
}
std::vector<double> numbers_of(std::int64_t value) {
  return {static_cast<double>(value)};
}
std::vector<double> numbers_of(const Interval& value) {
  return {value.min, value.max};
}
std::vector<double> numbers_of(const Eigen::Vector2d& value) {
  return {value.x(), value.y()};
}
std::vector<double> numbers_of(const Eigen::Vector3d& value) {
  return {value.x(), value.y(), value.z()};
}
void assign(const std::vector<double>& numbers, double& value) {
  value = numbers[0];
}
void assign(const std::vector<double>& numbers, std::int64_t& value) {
  value = static_cast<std::int64_t>(numbers[0]);
}
void assign(const std::vector<double>& numbers, Interval& value) {
  value = {numbers[0], numbers[1]};
}
template <int N>
void assign(const std::vector<double>& numbers, Eigen::Matrix<double, N, 1>& value) {
  value = Eigen::Map<const Eigen::Matrix<double, N, 1>>(numbers.data());
}

template <class T>
std::string allowed_text(double min, double max) {
  if constexpr (std::is_same_v<T, double>) return within("a number", Numbers{min, max});
  if constexpr (std::is_same_v<T, std::int64_t>) {
    return within("an integer", Integers{std::llround(min), std::llround(max)});
  }
  if constexpr (std::is_same_v<T, Interval>) {
    return within("two numbers, the smaller first,", Numbers{min, max});
  }
  return within(std::to_string(kSize<T>) + " numbers", Numbers{min, max});
}

template <class T>
bool is_allowed(const std::vector<double>& numbers, double min, double max) {
  if (numbers.size() != kSize<T>) return false;
  for (const double number : numbers) {
    if (!(number >= min && number <= max)) return false;
    if (std::is_same_v<T, std::int64_t> && number != std::floor(number)) return false;
  }
  return !std::is_same_v<T, Interval> || numbers.front() <= numbers.back();
}

template <class T>
std::string text_of(const T& value) {
  std::string text;
  for (const double number : numbers_of(value)) {
    if (!text.empty()) text += ',';
    text += decimal(number);
  }
  return text;
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

/// Groups with their kind of motion, which decides what else is to be said of them.
std::vector<ObstacleGroup> read_groups(const TomlTable& file) {
  std::vector<ObstacleGroup> groups;
  const TomlTable table = file.table("groups");
  for (const std::string& name : table.keys()) {
    const TomlTable group = table.table(name);
    const bool plain = std::all_of(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    if (!plain) table.reject(name, "a name of letters, digits and _");
    groups.emplace_back().name = name;
    groups.back().motion =
        static_cast<ObstacleMotionKind>(group.choice("motion", kObstacleMotionNames));
  }
  return groups;
}

void set_from_leaf(Scenario& scenario, const TomlTable::Leaf& leaf) {
  try {
    set_value(scenario, leaf.name, leaf.value, leaf.is_text);
  } catch (const ldm::InvalidInput& error) {
    throw ldm::InvalidInput(leaf.place + ": " + error.what());
  }
}

}  // namespace

Scenario read_scenario(const std::filesystem::path& path) {
  const TomlTable file = TomlTable::open(path);
  Scenario scenario;
  scenario.name = path.stem().string();
  scenario.title = file.text("title");
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
}

std::vector<std::pair<std::string, std::string>> scenario_values(const Scenario& scenario) {
  Writer writer;
  visit_scenario(scenario, writer);
  return std::move(writer.values);
}

std::string scenario_hash(const Scenario& scenario) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&hash](std::string_view text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  };
  for (const auto& [name, value] : scenario_values(scenario)) {
    add(name);
    add("=");
    add(value);
    add("\n");
  }
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

}  // namespace datasets
