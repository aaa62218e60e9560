#include "datasets/files/text.h"

#include <algorithm>
#include <cctype>

#include "ldm/parameter_text.h"

namespace datasets {
namespace {

/// Letters to change, add, leave out or swap with the next to come from one word to the other
/// (Damerau and Levenshtein, without edits between swapped letters).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, changed});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// Length of what both names begin with, up to a point.
std::size_t common_sections(std::string_view a, std::string_view b) {
  const std::size_t same = static_cast<std::size_t>(
      std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
  return a.substr(0, same).rfind('.') + 1;  // npos + 1 is 0
}

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

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t end = text.find(separator);
    words.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return words;
    text.remove_prefix(end + 1);
  }
}

std::string_view next_word(std::string_view& rest) {
  constexpr std::string_view kBlanks = " \t\r";
  rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
  rest.remove_prefix(word.size());
  return word;
}

std::string decimal(double value) {
  return ldm::ParameterValue<double>::text(value);
}

std::string rounded(double value, int decimals) {
  constexpr int kMostDigits = 330;  // of the largest double, before the point
  std::string text(static_cast<std::size_t>(kMostDigits + decimals), '\0');
  char* const end = std::to_chars(text.data(), text.data() + text.size(), value,
                                  std::chars_format::fixed, decimals)
                        .ptr;
  text.resize(static_cast<std::size_t>(end - text.data()));
  return text;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  std::string_view nearest;
  std::size_t least = name.size();
  for (const std::string& other : known) {
    const std::size_t own_part = name.size() - common_sections(name, other);
    const std::size_t edits = distance(name, other);
    if (edits < least && edits <= own_part / 3) {
      least = edits;
      nearest = other;
    }
  }
  return nearest.empty() ? "" : "; did you mean " + std::string(nearest) + "?";
}

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
