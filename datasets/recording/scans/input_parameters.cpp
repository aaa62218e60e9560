#include "datasets/recording/scans/input_parameters.h"

#include "datasets/files/text.h"
#include "ldm/parameter_text.h"

namespace datasets {
namespace {

/// @param low_name without "input." and "_m", as the other
void check_bounds(double low, double high, std::string_view low_name, std::string_view high_name) {
  if (low <= high) return;
  throw ldm::InvalidInput("input." + std::string(low_name) + "_m = " + decimal(low) +
                          ": allowed: at most input." + std::string(high_name) +
                          "_m = " + decimal(high));
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
  check_bounds(parameters.min_range, parameters.max_range, "min_range", "max_range");
  const auto& body = parameters.body;
  check_bounds(body.x_min, body.x_max, "body.x_min", "body.x_max");
  check_bounds(body.y_min, body.y_max, "body.y_min", "body.y_max");
  check_bounds(body.z_min, body.z_max, "body.z_min", "body.z_max");
}

}  // namespace datasets
