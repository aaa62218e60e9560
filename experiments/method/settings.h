#pragma once
/// Values given by name, from a study, a parameter file or the command line (no paper section).
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/files/toml_reader.h"
#include "datasets/recording/scans/input_parameters.h"
#include "datasets/scenario/scenario.h"
#include "ldm/parameters.h"

namespace experiments {

struct Setting {
  std::string name;   ///< a parameter's, or a scenario's with `scenario.` in front
  std::string value;  ///< as text
  std::string place;  ///< where it was given: `file:line` or the option of the command line
};
using Settings = std::vector<Setting>;

/// Every value below a table of a file, in the order of the file.
Settings settings_of(const datasets::TomlTable& table);

/// `name=value`, as after --set.
/// @throws ldm::InvalidInput without a name or an equals sign.
Setting parse_setting(std::string_view argument);

/// Every value of a parameter file, in its order.
/// @throws ldm::InvalidInput if the file cannot be read or is no TOML.
Settings read_settings(const std::filesystem::path& file);

/// @throws ldm::InvalidInput naming place, parameter, value and range.
void apply(const Setting& setting, ldm::Parameters& parameters);
void apply(const Setting& setting, datasets::InputParameters& parameters);

/// If the setting is of the scenario: its name there, else empty.
std::string_view scenario_key(const Setting& setting);
/// A setting of the scenario.
void apply(const Setting& setting, datasets::Scenario& scenario);

/// @throws ldm::InvalidInput: `place: name = value: allowed: ...`
[[noreturn]] void refuse(const Setting& setting, std::string_view allowed);

}  // namespace experiments
