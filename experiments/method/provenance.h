#pragma once
/// What made a result: source, build and machine (no paper section).
#include <string>

namespace experiments {

struct Provenance {
  std::string version;     ///< of the project
  std::string commit;      ///< the last that changed the program; "unknown" outside of git
  bool dirty = false;      ///< its sources differed from that commit
  std::string binary;      ///< build id of the running program: hash of its contents, in hex
  std::string compiler;    ///< name and version
  std::string flags;       ///< of the compiler
  std::string build_type;  ///< as CMake calls it
  std::string cpu;         ///< model name
  unsigned cores = 0;      ///< hardware threads
};

/// Of the running program.
Provenance provenance();

}  // namespace experiments
