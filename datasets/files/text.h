#pragma once
/// Messages and command lines in words: joined, quoted, on one line (no paper section).
#include <string>
#include <string_view>
#include <vector>

namespace datasets {

/// The words with `separator` between.
template <class Words>
std::string joined(const Words& words, std::string_view separator = ", ") {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

/// Line breaks and the blanks around them become one blank: a library's message on one line.
std::string single_line(std::string_view text);

/// The words as a command line, quoted where a shell would otherwise break them.
std::string command_line(const std::vector<std::string>& words);

}  // namespace datasets
