#pragma once
/// `ldm render`: what a method knows, as a picture of one frame or as a film (no paper section;
/// docs/pictures.md).
#include <cstdint>
#include <filesystem>
#include <optional>

#include "experiments/method/method_on_input.h"

namespace experiments {

/// Without `input`, `method` is the folder of a run, which is repeated.
struct RenderRequest : MethodOnInput {
  std::optional<std::filesystem::path> output;  ///< FILE.png
  std::optional<std::int64_t> frame;            ///< what it shows

  std::optional<std::filesystem::path> video;  ///< FILE.mp4
  std::int64_t from = 0;                       ///< the first frame that it shows
  std::optional<std::int64_t> to;              ///< the last one; absent: the last of all
};

/// The method runs from the first frame to the last one shown. Ctrl-C ends a film, which is kept.
/// @throws ldm::InvalidInput on a bad request or log, std::runtime_error if nothing can be drawn.
void render(const RenderRequest& request, const DataFolders& folders);

}  // namespace experiments
