#include "experiments/method/provenance.h"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <fstream>
#include <thread>

#include "experiments/method/build_stamp.h"

namespace experiments {
namespace {

std::string hex(const unsigned char* bytes, std::size_t count) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
  }
  return text;
}

/// The GNU build id among the notes of one segment; empty if it is not there.
std::string find_build_id(const unsigned char* note, std::size_t size) {
  const unsigned char* const end = note + size;
  const auto padded = [](std::size_t n) { return (n + 3) & ~std::size_t{3}; };
  while (note + sizeof(ElfW(Nhdr)) <= end) {
    ElfW(Nhdr) header;
    std::memcpy(&header, note, sizeof header);
    const unsigned char* const name = note + sizeof header;
    const unsigned char* const content = name + padded(header.n_namesz);
    if (header.n_type == NT_GNU_BUILD_ID && header.n_namesz == 4 &&
        std::memcmp(name, "GNU", 4) == 0) {
      return hex(content, header.n_descsz);
    }
    note = content + padded(header.n_descsz);
  }
  return {};
}

/// The linker writes the id into the program (-Wl,--build-id): no file needs to be read.
std::string build_id() {
  std::string id;
  const auto visit = [](dl_phdr_info* object, std::size_t, void* result) {
    for (int i = 0; i < object->dlpi_phnum; ++i) {
      const auto& segment = object->dlpi_phdr[i];
      if (segment.p_type != PT_NOTE) continue;
      const auto* note =
          reinterpret_cast<const unsigned char*>(object->dlpi_addr + segment.p_vaddr);
      const std::string found = find_build_id(note, segment.p_memsz);
      if (!found.empty()) *static_cast<std::string*>(result) = found;
    }
    return 1;  // the program itself comes first: stop before the shared libraries
  };
  dl_iterate_phdr(visit, &id);
  return id;
}

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t value = line.find(": ");
    if (value != std::string::npos) return line.substr(value + 2);
  }
  return "unknown";
}

}  // namespace

Provenance provenance() {
  return {.version = stamp::kVersion,
          .commit = stamp::kCommit,
          .dirty = stamp::kDirty,
          .binary = build_id(),
          .compiler = stamp::kCompiler,
          .flags = stamp::kFlags,
          .build_type = stamp::kBuildType,
          .cpu = cpu_model(),
          .cores = std::thread::hardware_concurrency()};
}

}  // namespace experiments
