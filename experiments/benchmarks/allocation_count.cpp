#include "experiments/benchmarks/allocation_count.h"

#include <malloc.h>

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstddef>

namespace benchmarks {
namespace {

constinit std::atomic<bool> counting{false};
constinit std::atomic<std::int64_t> blocks_taken{0};
constinit std::atomic<std::int64_t> bytes_in_use{0};
constinit std::atomic<std::int64_t> peak{0};

void* count_taken(void* block) {
  if (!counting.load(std::memory_order_relaxed) || block == nullptr) return block;
  const auto size = static_cast<std::int64_t>(malloc_usable_size(block));
  ++blocks_taken;
  const std::int64_t now = bytes_in_use += size;
  std::int64_t highest = peak;
  while (highest < now && !peak.compare_exchange_weak(highest, now)) {
  }
  return block;
}

void count_given_back(void* block) {
  if (!counting.load(std::memory_order_relaxed) || block == nullptr) return;
  bytes_in_use -= static_cast<std::int64_t>(malloc_usable_size(block));
}

}  // namespace

AllocationCount::AllocationCount() {
  blocks_taken = bytes_in_use = peak = 0;
  [[maybe_unused]] const bool already = counting.exchange(true);
  assert(!already);
}

AllocationCount::~AllocationCount() {
  counting = false;
}

std::int64_t AllocationCount::blocks() const {
  return blocks_taken;
}

std::int64_t AllocationCount::peak_bytes() const {
  return peak;
}

}  // namespace benchmarks

// glibc's own, under the names that a replaced malloc may call.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
  return benchmarks::count_taken(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) {
  return benchmarks::count_taken(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) {
  benchmarks::count_given_back(block);
  return benchmarks::count_taken(__libc_realloc(block, size));
}

void* memalign(std::size_t alignment, std::size_t size) {
  return benchmarks::count_taken(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  void* const block = memalign(alignment, size);
  if (block == nullptr) return ENOMEM;
  *result = block;
  return 0;
}

void free(void* block) {
  benchmarks::count_given_back(block);
  __libc_free(block);
}
}
