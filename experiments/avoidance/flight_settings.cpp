#include "experiments/avoidance/flight_settings.h"

#include <string>
#include <vector>

#include "datasets/files/text.h"
#include "datasets/files/toml_reader.h"

namespace experiments {
namespace {

bool is_of_flight(std::string_view name) {
  return name.starts_with("trust.") || name.starts_with("flight.");
}

/// Sets the value of one name.
struct Setter {
  const Setting& setting;
  bool found = false;
  std::vector<std::string> known = {};

  void operator()(std::string_view name, double& value, double min, double max) {
    known.emplace_back(name);
    if (name != setting.name) return;
    found = true;
    double number = 0;
    if (!datasets::parse_number(setting.value, number) || !(number >= min && number <= max)) {
      refuse(setting, datasets::within("a number", datasets::Numbers{min, max}));
    }
    value = number;
  }
};

}  // namespace

FlightSettings flight_settings(std::string_view arm) {
  FlightSettings settings;
  settings.arm = find_arm(arm);
  settings.map = arm_parameters(settings.arm);
  return settings;
}

bool uses(const FlightSettings& settings, std::string_view name) {
  if (is_of_flight(name)) return true;
  const Method* const method = settings.arm.method;
  return method != nullptr ? uses(*method, name) : name.starts_with("map.");
}

void apply(const Setting& setting, FlightSettings& settings) {
  if (is_of_flight(setting.name)) {
    Setter setter{setting};
    visit_flight_settings(settings, setter);
    if (!setter.found) {
      refuse(setting, "a value that docs/avoidance.md lists" +
                          datasets::did_you_mean(setting.name, setter.known));
    }
    return;
  }
  apply(setting, settings.map);
  if (!uses(settings, setting.name)) {
    refuse(setting, "values that the arm " + std::string(settings.arm.name) + " uses");
  }
}

}  // namespace experiments
