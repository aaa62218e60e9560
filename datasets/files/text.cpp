#include "datasets/files/text.h"

#include <algorithm>
#include <cctype>

namespace datasets {
namespace {

/// True if a shell takes the word as it stands.
bool is_plain(const std::string& word) {
  constexpr std::string_view kHarmless = "_-./=,:+";
  return !word.empty() && std::all_of(word.begin(), word.end(), [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || kHarmless.find(c) != kHarmless.npos;
  });
}

std::string quoted(const std::string& word) {
  std::string text(1, '\'');
  for (const char c : word) {
    if (c == '\'') text += "'\\'";
    text += c;
  }
  return text += '\'';
}

}  // namespace

std::string single_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (!std::isspace(static_cast<unsigned char>(c))) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

std::string command_line(const std::vector<std::string>& words) {
  std::vector<std::string> safe;
  safe.reserve(words.size());
  for (const std::string& word : words) safe.push_back(is_plain(word) ? word : quoted(word));
  return joined(safe, " ");
}

}  // namespace datasets
