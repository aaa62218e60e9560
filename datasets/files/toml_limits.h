#pragma once
/// What a TOML file may ask of a parser that calls itself at each level (no paper section).
#include <cstddef>
#include <string_view>

namespace datasets {

inline constexpr std::size_t kMostTomlBytes = std::size_t{16} << 20;
inline constexpr int kMostTomlLevels = 32;  ///< of brackets, and parts of a key such as a.b.c

/// One pass over the characters.
/// @param name of the file, for the message
/// @throws ldm::InvalidInput naming file, line, value and limit.
void check_toml_limits(std::string_view text, std::string_view name);

}  // namespace datasets
