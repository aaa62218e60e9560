// In place of parallel.cpp where there is no TBB: the parts run one after another, to the same
// bits.
#include "ldm/machine/parallel.h"

namespace ldm {

struct Parallel::Arena {};

Parallel::Parallel(std::int64_t threads)
    : parts_(static_cast<int>(threads == 0 ? at_once() : threads)) {}

std::int64_t Parallel::at_once() {
  return 1;
}

Parallel::~Parallel() = default;
Parallel::Parallel(Parallel&&) noexcept = default;
Parallel& Parallel::operator=(Parallel&&) noexcept = default;

void Parallel::run_parts(void (*call)(void*, int), void* body) const {
  for (int part = 0; part < parts_; ++part) call(body, part);
}

}  // namespace ldm
