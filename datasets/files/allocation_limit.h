#pragma once
/// A bound on what may be allocated for a while (no paper section).
#include <sys/resource.h>

#include <cstddef>

namespace datasets {

/// While it lives, an allocation that takes the process more than `bytes` beyond its present
/// address space fails with std::bad_alloc: damaged data cannot have all memory taken. It is the
/// process's limit, so other threads feel it too.
class AllocationLimit {
 public:
  explicit AllocationLimit(std::size_t bytes);
  ~AllocationLimit();
  AllocationLimit(const AllocationLimit&) = delete;
  AllocationLimit& operator=(const AllocationLimit&) = delete;

 private:
  rlimit before_{};
};

}  // namespace datasets
