/// A plugin whose methods have names that no file may have; which one, the environment says.
#include <cstdlib>

#include "ldm/local_dynamic_map.h"
#include "ldm/plugin.h"

LDM_PLUGIN(ldm::Method{.name = std::getenv("LDM_TEST_NAME"),
                       .help = "the LDM again",
                       .parameters = {"map"},
                       .create = ldm::create<ldm::LocalDynamicMap>})
