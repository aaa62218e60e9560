/// A plugin with a new method, and one whose name the program has.
#include "ldm/local_dynamic_map.h"
#include "ldm/plugin.h"

namespace {

ldm::Method row(const char* name) {
  return {.name = name,
          .help = "the LDM again",
          .parameters = {"map"},
          .create = ldm::create<ldm::LocalDynamicMap>};
}

}  // namespace

LDM_PLUGIN(row("new"), row("ldm"))
