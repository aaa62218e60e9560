#include "experiments/method/parameter_list.h"

#include <algorithm>
#include <cstdio>

#include "datasets/files/text.h"
#include "datasets/recording/scans/input_parameters.h"
#include "datasets/scenario/scenario_parameters.h"
#include "experiments/method/methods.h"

namespace experiments {
namespace {

using List = std::vector<ListedParameter>;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

ListedParameter row(const ldm::ParameterInfo& info, std::string value,
                    std::vector<std::string> words) {
  return {.name = std::string(info.name),
          .symbol = std::string(info.symbol),
          .value = std::move(value),
          .unit = std::string(info.unit),
          .min = info.min,
          .max = info.max,
          .words = std::move(words),
          .source = std::string(info.source),
          .help = std::string(info.help)};
}

/// What may be said in place of a number.
struct Words {
  template <class T>
  std::vector<std::string> operator()(const T&) const {
    return {};
  }
  std::vector<std::string> operator()(bool) const { return {"true", "false"}; }
  template <class Enum, class Names>
  std::vector<std::string> operator()(Enum, const Names& names) const {
    return {std::begin(names), std::end(names)};
  }
};

template <class Table, class Kept>
void add(const Table& table, Kept kept, List& list) {
  visit_parameters(table, [&](const ldm::ParameterInfo& info, const auto&... value) {
    if (kept(info)) list.push_back(row(info, get_parameter(table, info.name), Words()(value...)));
  });
}

List of_method(const Method* method) {
  List list;
  add(
      method != nullptr ? default_parameters(*method) : ldm::Parameters{},
      [&](const ldm::ParameterInfo& info) { return method == nullptr || uses(*method, info.name); },
      list);
  add(
      datasets::InputParameters{}, [](const ldm::ParameterInfo&) { return true; }, list);
  return list;
}

/// What a description of that kind may say, without the values.
void add_kind(datasets::FlightKind flight, datasets::ObstacleMotionKind motion, List& list) {
  datasets::Scenario scenario;
  scenario.uav.kind = flight;
  datasets::ObstacleGroup& group = scenario.groups.emplace_back();
  group.name = "NAME";
  group.shape = datasets::ObstacleShape::kWalker;
  group.motion = motion;
  visit_parameters(scenario, [&](const ldm::ParameterInfo& info, const auto&... value) {
    const auto same = [&](const ListedParameter& other) { return other.name == info.name; };
    if (std::none_of(list.begin(), list.end(), same)) {
      list.push_back(row(info, "", Words()(value...)));
    }
  });
}

List of_any_scenario() {
  List list;
  add_kind(datasets::FlightKind::kWaypoints, datasets::ObstacleMotionKind::kShuttle, list);
  add_kind(datasets::FlightKind::kTimetable, datasets::ObstacleMotionKind::kTimetable, list);
  const auto section = [](const ListedParameter& p) { return p.name.substr(0, p.name.find('.')); };
  // Those that only the second kind has join their section.
  const std::vector<std::string> order = {"frames", "area", "sensor", "obstacles", "uav", "groups"};
  const auto place = [&](const ListedParameter& p) {
    return std::find(order.begin(), order.end(), section(p));
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return list;
}

List of_scenario(const std::filesystem::path& file) {
  const datasets::Scenario scenario = datasets::read_scenario(file);
  std::vector<std::pair<std::string, std::string>> values = datasets::scenario_values(scenario);
  List list;
  visit_parameters(scenario, [&](const ldm::ParameterInfo& info, const auto&... value) {
    list.push_back(row(info, values[list.size()].second, Words()(value...)));
  });
  return list;
}

}  // namespace

std::string ListedParameter::range() const {
  if (!words.empty()) return datasets::joined(words, "|");
  return number(min).append("..").append(number(max));
}

std::vector<ListedParameter> listed_parameters(const std::optional<std::string>& of,
                                               const DataFolders& folders) {
  if (!of) return of_method(nullptr);
  if (*of == "scenario") return of_any_scenario();
  const std::vector<std::string> scenarios = folders.scenarios.names();
  const bool is_scenario = of->ends_with(".toml") ||
                           std::find(scenarios.begin(), scenarios.end(), *of) != scenarios.end();
  if (is_scenario) return of_scenario(folders.scenarios.file(*of));
  std::vector<std::string> known{"scenario"};
  known.insert(known.end(), scenarios.begin(), scenarios.end());
  for (const Method& method : methods()) {
    if (method.name == *of) return of_method(&method);
    known.emplace_back(method.name);
  }
  throw ldm::InvalidInput("unknown method or scenario " + *of + ": allowed: " +
                          datasets::joined(known) + datasets::did_you_mean(*of, known));
}

}  // namespace experiments
