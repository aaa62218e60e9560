#pragma once
/// Lists for programs, as JSON: an array of objects (no paper section).
#include <string>

#include "experiments/method/parameter_list.h"

namespace experiments {

/// name, help, finds_clusters, parameters (sections or names), overrides (name -> text), plugin
/// (file name, or null for the program's own).
std::string methods_json();

/// name, symbol, value (text), unit, min, max, words, source, help; min and max are null of words,
/// value is null of a scenario without a name.
std::string parameters_json(const std::vector<ListedParameter>& parameters);

}  // namespace experiments
