#pragma once
/// Whether there is a screen (no paper section).

namespace experiments {

/// True if a window can appear: DISPLAY names an X server that answers.
bool has_display();

}  // namespace experiments
