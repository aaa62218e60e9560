#pragma once
/// Methods from outside: shared objects of `--plugin FILE` (no paper section; docs/variants.md).
#include <filesystem>
#include <optional>
#include <string>

#include "experiments/method/methods.h"

namespace experiments {

struct PluginFile {
  std::string name;  ///< without folder
  std::string hash;  ///< of its contents, in hex
};

/// Loads the file, for as long as the program runs, and adds its methods to the table.
/// @throws ldm::InvalidInput if it is missing, no plugin, or one of another interface, and if one
/// of its methods has the name of another, one of other characters than ldm/plugin.h allows, or
/// cannot be created; no method is then added.
void load_plugin(const std::filesystem::path& file);

/// The plugin that `method` of the table came from; absent for the program's own.
std::optional<PluginFile> plugin_of(const Method& method);

}  // namespace experiments
