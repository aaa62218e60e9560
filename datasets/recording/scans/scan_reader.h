#pragma once
/// What every reader of recorded scans answers beside the frames (no paper section).
#include <string>

#include "datasets/frame.h"

namespace datasets {

/// `next` gives the frames as the recording has them, with its own numbers in `index`, and throws
/// BrokenFrame for one that cannot be used: the next call goes on after it.
class ScanReader : public FrameSource {
 public:
  /// Where the last frame stands, for messages: a file with its line or number of the object.
  virtual std::string place() const = 0;
};

}  // namespace datasets
