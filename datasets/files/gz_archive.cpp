#include "datasets/files/gz_archive.h"

#include <mrpt/core/aligned_allocator.h>

#include <cstdlib>
#include <new>

#include "datasets/files/allocation_limit.h"

/// In place of MRPT's own, which returns null where its allocator is expected to throw: every
/// vector that MRPT makes as long as a damaged file says would then be written to address 0.
void* mrpt::aligned_malloc(std::size_t size, std::size_t alignment) {
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* const memory = std::aligned_alloc(alignment, whole);
  if (memory == nullptr && whole > 0) throw std::bad_alloc();
  return memory;
}

namespace datasets {

mrpt::serialization::CSerializable::Ptr GzArchive::read_object() {
  constexpr std::size_t kLargestObject = std::size_t{512} << 20;  // [bytes]: ten sweeps and more
  const AllocationLimit limit(kLargestObject);
  try {
    return ReadObject();
  } catch (const std::exception&) {
    return nullptr;
  }
}

}  // namespace datasets
