#include "experiments/method/sees_truth.h"

#include <string>

namespace experiments {

void update(ldm::Mapper& mapper, const datasets::Frame& frame, ldm::StageListener* listener) {
  if (auto* oracle = dynamic_cast<SeesTruth*>(&mapper)) {
    if (!frame.truth) {
      throw ldm::InvalidInput("frame " + std::to_string(frame.index) +
                              ": has no truth: allowed for an oracle: scenarios, and logs of "
                              "`ldm simulate` with their truth");
    }
    oracle->see(*frame.truth);
  }
  mapper.update(frame.scan, listener);
}

}  // namespace experiments
