/// A plugin whose method cannot be made.
#include "ldm/plugin.h"

LDM_PLUGIN(ldm::Method{.name = "idle", .help = "forgot its create", .parameters = {}})
