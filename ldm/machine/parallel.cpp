#include "ldm/machine/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace ldm {

struct Parallel::Arena {
  tbb::task_arena arena;
};

Parallel::Parallel(std::int64_t threads)
    : parts_(static_cast<int>(threads == 0 ? at_once() : threads)) {
  if (parts_ > 1) arena_ = std::make_unique<Arena>(Arena{tbb::task_arena(parts_)});
}

std::int64_t Parallel::at_once() {
  return tbb::this_task_arena::max_concurrency();
}

Parallel::~Parallel() = default;
Parallel::Parallel(Parallel&&) noexcept = default;
Parallel& Parallel::operator=(Parallel&&) noexcept = default;

void Parallel::run_parts(void (*call)(void*, int), void* body) const {
  arena_->arena.execute([&] {
    tbb::parallel_for(
        0, parts_, [&](int part) { call(body, part); }, tbb::simple_partitioner());
  });
}

}  // namespace ldm
