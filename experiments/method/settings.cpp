#include "experiments/method/settings.h"

#include <algorithm>

#include "datasets/files/at_place.h"
#include "datasets/files/text.h"

namespace experiments {
namespace {

/// The library refuses a name that the table lacks without saying which it may have meant.
template <class Table>
void check_name(const Table& table, const Setting& setting) {
  std::vector<std::string> known;
  visit_parameters(table, [&](const ldm::ParameterInfo& info, const auto&, const auto&...) {
    known.emplace_back(info.name);
  });
  if (std::find(known.begin(), known.end(), setting.name) != known.end()) return;
  throw ldm::InvalidInput("unknown parameter " + setting.name +
                          ": allowed: a name that `ldm parameters` lists" +
                          datasets::did_you_mean(setting.name, known));
}

template <class Table>
void apply_to(Table& parameters, const Setting& setting) {
  datasets::at_place(setting.place, [&] {
    check_name(parameters, setting);
    set_parameter(parameters, setting.name, setting.value);
  });
}

}  // namespace

Settings settings_of(const datasets::TomlTable& table) {
  Settings settings;
  for (const auto& leaf : table.leaves()) settings.push_back({leaf.name, leaf.value, leaf.place});
  return settings;
}

Setting parse_setting(std::string_view argument) {
  const std::size_t equals = argument.find('=');
  if (equals == 0 || equals == std::string_view::npos) {
    throw ldm::InvalidInput("--set " + std::string(argument) +
                            ": allowed: name=value, as in particles.count=1000");
  }
  return {std::string(argument.substr(0, equals)), std::string(argument.substr(equals + 1)),
          "--set"};
}

Settings read_settings(const std::filesystem::path& file) {
  return settings_of(datasets::TomlTable::open(file));
}

void apply(const Setting& setting, ldm::Parameters& parameters) {
  apply_to(parameters, setting);
}

void apply(const Setting& setting, datasets::InputParameters& parameters) {
  apply_to(parameters, setting);
}

std::string_view scenario_key(const Setting& setting) {
  constexpr std::string_view kPrefix = "scenario.";
  std::string_view name = setting.name;
  if (!name.starts_with(kPrefix)) return {};
  return name.substr(kPrefix.size());
}

void apply(const Setting& setting, datasets::Scenario& scenario) {
  datasets::at_place(setting.place + ": scenario", [&] {
    datasets::set_scenario_value(scenario, scenario_key(setting), setting.value);
  });
}

void refuse(const Setting& setting, std::string_view allowed) {
  throw ldm::InvalidInput(setting.place + ": " + setting.name + " = " + setting.value +
                          ": allowed: " + std::string(allowed));
}

}  // namespace experiments
