#pragma once
/// A row of the methods table, and how a shared object hands rows over (no paper section;
/// docs/variants.md).
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "ldm/mapper.h"
#include "ldm/parameters.h"

namespace ldm {

/// Version of all that program and plugin both know: this header, mapper.h, types.h and
/// parameters.h. A plugin of another version is refused. Raised by every change of a type in them,
/// a new parameter included.
inline constexpr int kPluginInterface = 2;

/// A mapper that can be run and compared by its name.
struct Method {
  std::string_view name;  ///< letters, digits, _ and -
  std::string_view help;
  bool finds_clusters = false;  ///< without clusters there is no velocity to score
  /// What it reads of the parameters: `section`, or `section.key`.
  std::vector<std::string_view> parameters;
  /// Where it departs from the defaults of parameters.h: name and value.
  std::vector<std::pair<std::string_view, std::string_view>> overrides = {};
  std::unique_ptr<Mapper> (*create)(const Parameters&) = nullptr;
};

/// For Method::create.
template <class M>
std::unique_ptr<Mapper> create(const Parameters& parameters) {
  return std::make_unique<M>(parameters);
}

}  // namespace ldm

/// Makes a shared object a plugin: `LDM_PLUGIN(row)` or `LDM_PLUGIN(row, row, ...)`, once, outside
/// of any namespace. The program asks for the interface before it takes the rows.
#define LDM_PLUGIN(...)                                                          \
  extern "C" __attribute__((visibility("default"))) int ldm_plugin_interface() { \
    return ldm::kPluginInterface;                                                \
  }                                                                              \
  extern "C" __attribute__((visibility("default"))) void ldm_plugin_methods(     \
      std::vector<ldm::Method>& methods) {                                       \
    methods = {__VA_ARGS__};                                                     \
  }
