#pragma once
/// Counts what a stretch of code takes from the heap (no paper section).
///
/// Linking allocation_count.cpp replaces malloc and its kin, and with them operator new, by ones
/// that pass on to glibc's and count on the way. TBB takes the memory of its tasks from an
/// allocator of its own where libtbbmalloc is installed: that is not seen.
#include <cstdint>

namespace benchmarks {

/// Counts from its making to its end, over all threads; one at a time.
class AllocationCount {
 public:
  AllocationCount();
  ~AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;

  /// Blocks taken so far.
  std::int64_t blocks() const;
  /// Most bytes in use at one time so far; what was taken before counts nothing, but lessens the
  /// sum when it is given back.
  std::int64_t peak_bytes() const;
};

}  // namespace benchmarks
