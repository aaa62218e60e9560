/// A bound on allocations that ends with its scope.
#include "datasets/files/allocation_limit.h"

#include <gtest/gtest.h>

#include <new>

namespace datasets {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// Reserved, not touched: it takes address space alone.
bool can_allocate(std::size_t bytes) {
  try {
    ::operator delete(::operator new(bytes));  // which, unlike `new`, is never left out
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

TEST(AllocationLimit, BoundsWhatIsAllocatedInItsScope) {
  ASSERT_TRUE(can_allocate(512 * kMegabyte));
  {
    const AllocationLimit limit(256 * kMegabyte);
    EXPECT_TRUE(can_allocate(64 * kMegabyte));
    EXPECT_FALSE(can_allocate(512 * kMegabyte));
    {
      const AllocationLimit wider(1024 * kMegabyte);
      EXPECT_FALSE(can_allocate(512 * kMegabyte));
    }
  }
  EXPECT_TRUE(can_allocate(512 * kMegabyte));
}

}  // namespace
}  // namespace datasets
