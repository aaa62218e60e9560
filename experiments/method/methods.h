#pragma once
/// The methods table: every compared mapper, one row each (paper Sec. 4.1.2 and beyond).
#include <deque>
#include <string_view>
#include <vector>

#include "experiments/method/settings.h"
#include "ldm/parameters.h"
#include "ldm/plugin.h"

namespace experiments {

using Method = ldm::Method;

/// All rows, in the order of tables and lists. A new variant is one more row.
const std::deque<Method>& methods();

/// More rows at the end, of plugins; rows never move.
/// @throws ldm::InvalidInput if a name exists already; no row is then added.
void add_methods(const std::vector<Method>& rows);

/// @throws ldm::InvalidInput `unknown method ...`, listing the known ones.
const Method& find_method(std::string_view name);

/// The defaults with the method's own overrides.
ldm::Parameters default_parameters(const Method& method);

/// True if the method reads the parameter of that name.
bool uses(const Method& method, std::string_view parameter);

/// As `apply`, for one method.
/// @throws ldm::InvalidInput also if the method does not use the parameter.
void apply(const Setting& setting, const Method& method, ldm::Parameters& parameters);

}  // namespace experiments
