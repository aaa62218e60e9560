#pragma once
/// Oracles: methods that are shown the truth (no paper section; docs/objects.md).
#include "datasets/frame.h"
#include "ldm/mapper.h"

namespace experiments {

/// What a mapper is besides if it is an oracle.
class SeesTruth {
 public:
  virtual ~SeesTruth() = default;
  /// Of the scan that comes next.
  virtual void see(const datasets::Truth& truth) = 0;
};

/// One frame into a mapper, which is shown its truth first if it is an oracle.
/// @throws ldm::InvalidInput also if it is one and the frame has none.
void update(ldm::Mapper& mapper, const datasets::Frame& frame,
            ldm::StageListener* listener = nullptr);

}  // namespace experiments
