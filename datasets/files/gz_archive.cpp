#include "datasets/files/gz_archive.h"

#include <mrpt/core/aligned_allocator.h>
#include <mrpt/version.h>

#include <new>
#include <regex>

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
namespace {

/// What of MRPT's message says that the object is of a newer MRPT than this one; else empty.
std::string newer_class(const std::string& message) {
  std::smatch found;
  static const std::regex unknown_class(
      "class '((mrpt::)?[a-z:]*C[A-Za-z0-9_]+)' which is not reg");
  static const std::regex unknown_version("unknown serialization version number: '([0-9]+)'");
  std::string what;
  if (std::regex_search(message, found, unknown_class)) what = "the class " + found[1].str();
  if (std::regex_search(message, found, unknown_version)) what = "version " + found[1].str();
  if (what.empty()) return {};
  const auto digit = [](int place) { return std::to_string(MRPT_VERSION >> 4 * place & 0xf); };
  return what + " of an object is unknown to MRPT " + digit(2) + "." + digit(1) + "." + digit(0) +
         ": the log is a newer one's, or damaged";
}

}  // namespace

mrpt::serialization::CSerializable::Ptr GzArchive::read_object() {
  constexpr std::size_t kLargestObject = std::size_t{512} << 20;  // [bytes]: ten sweeps and more
  const AllocationLimit limit(kLargestObject);
  try {
    return ReadObject();
  } catch (const std::exception& error) {
    const std::string newer = newer_class(error.what());
    if (!newer.empty()) failure_ = newer;
    return nullptr;
  }
}

}  // namespace datasets
