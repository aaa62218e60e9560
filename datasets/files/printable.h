#pragma once
/// Names that a file holds, for messages of one line (no paper section).
#include <string>
#include <string_view>

namespace datasets {

/// With a question mark for each control character, of which line breaks are some.
inline std::string printable(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < ' ' || code == 0x7f) c = '?';
  }
  return text;
}

}  // namespace datasets
