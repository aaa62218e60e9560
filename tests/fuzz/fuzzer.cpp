/// One fuzzer of libFuzzer for each target of targets.h: FUZZ_TARGET names it.
#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

#include "tests/fuzz/targets.h"

namespace {

std::atomic<std::size_t> allocated = 0;  // [bytes], by operator new

}  // namespace

/// Fails as the program's does, which has a limit while MRPT reads. AddressSanitizer's never
/// throws, and knows no such limit: its memory is set aside beforehand.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  constexpr std::size_t kLimit = std::size_t{1} << 30;
  void* const memory = allocated + size < kLimit ? std::malloc(size) : nullptr;
  allocated += malloc_usable_size(memory);
  return memory;
}
void* operator new(std::size_t size) {
  void* const memory = operator new(size, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  allocated -= malloc_usable_size(memory);
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

/// The functions of C fail as they do in the program.
extern "C" const char* __asan_default_options() {  // NOLINT: the sanitizer's name
  return "allocator_may_return_null=1";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
