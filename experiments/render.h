#pragma once
/// `ldm render`: what a method knows after one frame, as a picture (no paper section).
#include <cstdint>
#include <filesystem>

#include "experiments/method_on_input.h"

namespace experiments {

struct RenderRequest : MethodOnInput {
  std::int64_t frame = 0;        ///< the method runs from the first frame to this one
  std::filesystem::path output;  ///< FILE.png
};

/// @throws ldm::InvalidInput on a bad request or log, std::runtime_error if nothing can be drawn.
void render(const RenderRequest& request, const DataFolders& folders);

}  // namespace experiments
