#include "datasets/scenario/scenario.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "datasets/files/at_place.h"
#include "datasets/files/text.h"
#include "datasets/files/toml_reader.h"
#include "datasets/hash.h"
#include "datasets/scenario/scenario_parameters.h"
#include "datasets/scenario/scenario_value.h"
#include "datasets/scenario/timetable.h"

namespace datasets {
namespace {

/// Numbers separated by commas; empty if the text is anything else.
std::vector<double> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : split(text, ',')) {
    if (!parse_number(word, numbers.emplace_back())) return {};
  }
  return numbers;
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
  void operator()(const ldm::ParameterInfo& info, T& value) {
    if (info.name != name) return;
    found = true;
    const std::vector<double> numbers = parse_numbers(text);
    if (quoted || !is_allowed<T>(numbers, info.min, info.max)) {
      reject(name, quoted ? '"' + std::string(text) + '"' : std::string(text),
             allowed_text<T>(info.min, info.max));
    }
    assign(numbers, value);
  }
  template <class Enum, std::size_t N>
  void operator()(const ldm::ParameterInfo& info, Enum& value, const std::string_view (&words)[N]) {
    if (info.name != name) return;
    found = true;
    const auto word = std::find(std::begin(words), std::end(words), text);
    if (word == std::end(words)) reject(name, text, one_of(words));
    value = static_cast<Enum>(word - std::begin(words));
  }
};

void set_value(Scenario& scenario, std::string_view name, std::string_view text, bool quoted) {
  Setter setter{name, text, quoted};
  visit_parameters(scenario, setter);
  if (setter.found) return;
  std::vector<std::string> known;
  visit_parameters(scenario, [&](const ldm::ParameterInfo& info, auto&, auto&...) {
    known.emplace_back(info.name);
  });
  reject(name, text, "a key that scenarios have" + did_you_mean(name, known));
}

/// Collects name and value of every field.
struct Writer {
  std::vector<std::pair<std::string, std::string>> values;

  template <class T>
  void operator()(const ldm::ParameterInfo& info, const T& value) {
    values.emplace_back(info.name, text_of(value));
  }
  template <class Enum, std::size_t N>
  void operator()(const ldm::ParameterInfo& info, Enum value, const std::string_view (&words)[N]) {
    values.emplace_back(info.name, words[static_cast<std::size_t>(value)]);
  }
};

/// Throws at the first value out of its range.
struct Checker {
  template <class T>
  void operator()(const ldm::ParameterInfo& info, const T& value) {
    if (is_allowed<T>(numbers_of(value), info.min, info.max)) return;
    reject(info.name, text_of(value), allowed_text<T>(info.min, info.max));
  }
  template <class Enum, std::size_t N>
  void operator()(const ldm::ParameterInfo&, Enum, const std::string_view (&)[N]) {}
};

bool may_be_missing(std::string_view name) {
  return name == "sensor.pose_sigma_m" || name == "sensor.position_m" ||
         name == "sensor.roll_pitch_yaw_deg";
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
  visit_parameters(scenario, Checker());
  for (const ObstacleGroup& group : scenario.groups) check_timetable(group);
}

std::vector<std::pair<std::string, std::string>> scenario_values(const Scenario& scenario) {
  Writer writer;
  visit_parameters(scenario, writer);
  return std::move(writer.values);
}

std::string scenario_hash(const Scenario& scenario) {
  Fnv1a fnv;
  for (const auto& [name, value] : scenario_values(scenario)) {
    // It came later, and without it the world is that of before.
    if (name == "sensor.pose_sigma_m" && scenario.sensor.pose_sigma == 0) continue;
    fnv.add(name);
    fnv.add("=");
    fnv.add(value);
    fnv.add("\n");
  }
  return hex(fnv.value());
}

}  // namespace datasets
