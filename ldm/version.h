#pragma once
/// Version of the project, once: CMake reads it here (no paper section).

namespace ldm {

inline constexpr char kVersion[] = "0.1.0";

}  // namespace ldm
