#pragma once
/// Numbers, messages and command lines as text: joined, quoted, on one line (no paper section).
#include <charconv>
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

/// What stands between the separators; at least one word, which may be empty.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Takes the next word from `rest`; blanks, tabs and carriage returns part words. Empty if none is
/// left.
std::string_view next_word(std::string_view& rest);

/// Shortest decimal that reads back to the same bits.
std::string decimal(double value);
/// With so many digits after the point.
std::string rounded(double value, int decimals);

/// True if all of `text` is one number.
template <class Number>
bool parse_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// For messages about a name that is unknown: "; did you mean NAME?" of the nearest known one,
/// empty if none is near: a third of the letters, without sections that are right, may be wrong,
/// missing or swapped with their neighbours.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

/// Line breaks and the blanks around them become one blank: a library's message on one line.
std::string single_line(std::string_view text);

/// The words as a command line, quoted where a shell would otherwise break them.
std::string command_line(const std::vector<std::string>& words);

}  // namespace datasets
