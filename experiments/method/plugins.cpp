#include "experiments/method/plugins.h"

#include <dlfcn.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>

#include "datasets/hash.h"

namespace experiments {
namespace {

namespace fs = std::filesystem;

using Interface = int();
using Methods = void(std::vector<ldm::Method>&);

/// The plugins of the methods that came from one, by name.
std::map<std::string_view, PluginFile>& origins() {
  static std::map<std::string_view, PluginFile> map;
  return map;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw ldm::InvalidInput("--plugin " + file.string() + ": " + reason);
}

/// The plugin's own copy of the library stays its own (RTLD_LOCAL), and nothing is missing that it
/// would miss in mid-run (RTLD_NOW).
void* open(const fs::path& file) {
  if (!fs::is_regular_file(file)) refuse(file, "no such file: allowed: a shared object");
  // Without a slash, dlopen would look for the file elsewhere.
  void* const library = dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    refuse(file, std::string("cannot be loaded (") + dlerror() + "): allowed: a shared object");
  }
  return library;
}

template <class Function>
Function* find(const fs::path& file, void* library, const char* name) {
  void* const symbol = dlsym(library, name);
  if (symbol == nullptr) {
    refuse(file, std::string("has no ") + name +
                     ": allowed: a shared object with LDM_PLUGIN of ldm/plugin.h");
  }
  return reinterpret_cast<Function*>(symbol);
}

void check_interface(const fs::path& file, int version) {
  if (version == ldm::kPluginInterface) return;
  refuse(file, "interface " + std::to_string(version) + ": allowed: interface " +
                   std::to_string(ldm::kPluginInterface) +
                   "; build it with the library of this program");
}

/// Records and folders are named after methods.
void check_name(const fs::path& file, std::string_view name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  if (!name.empty() && plain) return;
  refuse(file, "method \"" + std::string(name) + "\": allowed: a name of letters, digits, _ and -");
}

PluginFile describe(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string contents{std::istreambuf_iterator<char>(stream), {}};
  return {file.filename().string(), datasets::hex(datasets::hash({contents}))};
}

}  // namespace

void load_plugin(const fs::path& file) {
  void* const library = open(file);
  check_interface(file, find<Interface>(file, library, "ldm_plugin_interface")());
  std::vector<ldm::Method> rows;
  find<Methods>(file, library, "ldm_plugin_methods")(rows);
  for (const ldm::Method& row : rows) {
    check_name(file, row.name);
    if (row.create == nullptr) refuse(file, "method " + std::string(row.name) + " has no create");
  }
  try {
    add_methods(rows);
  } catch (const ldm::InvalidInput& error) {
    refuse(file, error.what());
  }
  const PluginFile plugin = describe(file);
  for (const ldm::Method& row : rows) origins()[row.name] = plugin;
}

std::optional<PluginFile> plugin_of(const Method& method) {
  const auto found = origins().find(method.name);
  if (found == origins().end()) return std::nullopt;
  return found->second;
}

}  // namespace experiments
