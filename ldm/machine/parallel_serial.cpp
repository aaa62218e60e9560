// In place of parallel.cpp where there is no TBB: the parts run one after another, to the same
// bits.
#include "ldm/machine/parallel.h"

namespace ldm {

struct Parallel::Arena {};

Parallel::Parallel(std::int64_t threads) : parts_(threads == 0 ? 1 : static_cast<int>(threads)) {}

Parallel::~Parallel() = default;
Parallel::Parallel(Parallel&&) noexcept = default;
Parallel& Parallel::operator=(Parallel&&) noexcept = default;

void Parallel::run_parts(void (*call)(void*, int), void* body) const {
  for (int part = 0; part < parts_; ++part) call(body, part);
}

}  // namespace ldm
