/// A plugin of the next interface: nothing but its version may be asked for.
#include <cstdlib>

#include "ldm/plugin.h"

extern "C" int ldm_plugin_interface() {
  return ldm::kPluginInterface + 1;
}
extern "C" void ldm_plugin_methods(std::vector<ldm::Method>&) {
  std::abort();
}
