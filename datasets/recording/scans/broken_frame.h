#pragma once
/// A frame of a recording that cannot be used, while those after it may be (no paper section).
#include <string>
#include <utility>

#include "ldm/types.h"

namespace datasets {

/// The reader that throws it goes on with the frame after.
struct BrokenFrame : ldm::InvalidInput {
  /// @param why a few words under which such frames are counted
  /// @param message one line that names file, place, value and what is allowed
  BrokenFrame(std::string why, const std::string& message)
      : ldm::InvalidInput(message), reason(std::move(why)) {}

  std::string reason;
};

}  // namespace datasets
