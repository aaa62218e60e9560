#include "datasets/recording/scans/input_parameters.h"

#include "ldm/parameter_text.h"

namespace datasets {
namespace {

void check_bounds(const InputParameters& parameters, std::string_view low, std::string_view high) {
  const std::string min = get_parameter(parameters, low), max = get_parameter(parameters, high);
  if (std::stod(min) <= std::stod(max)) return;
  throw ldm::InvalidInput(std::string(low) + " = " + min + ": allowed: at most " +
                          std::string(high) + " = " + max);
}

}  // namespace

bool is_input_parameter(std::string_view name) {
  return name.starts_with("input.");
}

std::string get_parameter(const InputParameters& parameters, std::string_view name) {
  return ldm::parameter_text(parameters, name);
}

void set_parameter(InputParameters& parameters, std::string_view name, std::string_view text) {
  ldm::set_parameter_text(parameters, name, text);
}

void check(const InputParameters& parameters) {
  check_bounds(parameters, "input.min_range_m", "input.max_range_m");
  check_bounds(parameters, "input.body.x_min_m", "input.body.x_max_m");
  check_bounds(parameters, "input.body.y_min_m", "input.body.y_max_m");
  check_bounds(parameters, "input.body.z_min_m", "input.body.z_max_m");
}

}  // namespace datasets
