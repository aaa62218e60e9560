#pragma once
/// What a configuration names, made ready to be timed step by step (no paper section).
#include <memory>

#include "experiments/benchmarks/configuration.h"
#include "experiments/benchmarks/scans.h"
#include "ldm/mapper.h"

namespace benchmarks {

class Subject {
 public:
  virtual ~Subject() = default;
  /// What happens before the clock of step k starts; must be called before it.
  virtual void prepare(std::size_t) {}
  /// Step k of 0, 1, 2, ...: all subjects see the same frame k of the flight.
  virtual void step(std::size_t k, ldm::StageListener& listener) = 0;
};

/// @param scans must outlive the subject; bounds and simulation need none
/// @throws ldm::InvalidInput if there is no such subject.
std::unique_ptr<Subject> make_subject(const Configuration& configuration, Scans& scans,
                                      std::int64_t frames);

}  // namespace benchmarks
