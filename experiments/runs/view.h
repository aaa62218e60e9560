#pragma once
/// `ldm view`: what a method knows, in a window while it runs (no paper section; docs/pictures.md).
#include "experiments/method/method_on_input.h"

namespace experiments {

struct ViewRequest : MethodOnInput {
  double rate = 1;      ///< times the log's own speed
  bool paused = false;  ///< at the first frame
};

/// Returns when the user closes the window or presses q.
/// @throws ldm::InvalidInput on a bad request or log, and where no window can be opened.
void view(const ViewRequest& request, const DataFolders& folders);

}  // namespace experiments
