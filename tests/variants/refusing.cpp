/// A plugin that throws the library's exception across the border, and one of its own.
#include <stdexcept>

#include "ldm/plugin.h"

namespace {

struct Refusal : ldm::InvalidInput {
  using InvalidInput::InvalidInput;
};

std::unique_ptr<ldm::Mapper> refuse(const ldm::Parameters&) {
  throw Refusal("map.voxels = 32: allowed: none");
}

std::unique_ptr<ldm::Mapper> fail(const ldm::Parameters&) {
  throw std::runtime_error("out of luck");
}

}  // namespace

LDM_PLUGIN(
    ldm::Method{.name = "refusing", .help = "takes nothing", .parameters = {}, .create = refuse},
    ldm::Method{.name = "failing", .help = "takes all", .parameters = {}, .create = fail})
