#include "datasets/recording/scans/scan_names.h"

#include <algorithm>
#include <cctype>

#include "datasets/files/text.h"
#include "ldm/types.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool begins_with_digit(std::string_view text) {
  return !text.empty() && is_digit(text.front());
}
bool begins_with_fraction(std::string_view text) {
  return text.size() > 1 && text[0] == '.' && is_digit(text[1]);
}

/// Takes the digits at the beginning.
std::string_view take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

/// The same without leading zeros; empty for 0 and where there is none.
std::string_view take_number(std::string_view& text) {
  std::string_view digits = take_digits(text);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

/// The digits after the dot at the beginning, without zeros at their end.
std::string_view take_fraction(std::string_view& text) {
  if (!begins_with_fraction(text)) return {};
  text.remove_prefix(1);
  const std::string_view digits = take_digits(text);
  return digits.substr(0, digits.find_last_not_of('0') + 1);
}

/// The number that a name is, without its ending.
std::optional<std::int64_t> number_of(const std::string& name) {
  constexpr std::size_t kMostDigits = 9;  // more, but for zeros in front, are a time
  const std::string_view stem = std::string_view(name).substr(0, name.rfind('.'));
  const std::size_t zeros = std::min(stem.find_first_not_of('0'), stem.size());
  std::int64_t number = 0;
  const bool is_one =
      begins_with_digit(stem) && stem.size() - zeros <= kMostDigits && parse_number(stem, number);
  return is_one ? std::optional(number) : std::nullopt;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b, bool fractions) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (begins_with_digit(a) && begins_with_digit(b)) {
      const std::string_view x = take_number(a), y = take_number(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      if (!fractions) continue;
      const std::string_view fraction_x = take_fraction(a), fraction_y = take_fraction(b);
      if (fraction_x != fraction_y) return fraction_x < fraction_y;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;  // 01 and 1
}

bool have_fractions(const std::vector<std::string>& names) {
  std::size_t shortest = std::string::npos, longest = 0;
  for (const std::string_view name : names) {
    for (std::string_view rest = name; !rest.empty();) {
      if (!begins_with_digit(rest)) {
        rest.remove_prefix(1);
        continue;
      }
      take_digits(rest);
      if (!begins_with_fraction(rest)) continue;
      rest.remove_prefix(1);
      const std::string_view digits = take_digits(rest);
      if (digits.size() > 1 && digits.back() == '0') return false;
      shortest = std::min(shortest, digits.size());
      longest = std::max(longest, digits.size());
    }
  }
  return shortest < longest;
}

bool is_scan_name(const fs::path& file, std::string_view ending) {
  const std::string name = file.filename().string();
  if (name.size() <= ending.size() || name.front() == '.') return false;
  return std::equal(ending.rbegin(), ending.rend(), name.rbegin(), [](char e, char c) {
    return e == std::tolower(static_cast<unsigned char>(c));
  });
}

std::vector<std::string> scan_names(const fs::path& folder, std::string_view ending) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (is_scan_name(entry.path(), ending)) names.push_back(entry.path().filename().string());
  }
  if (error) {
    throw ldm::InvalidInput(folder.string() + ": cannot be read (" + error.message() + ")");
  }
  if (names.empty()) {
    throw ldm::InvalidInput(folder.string() + ": has no scans (*" + std::string(ending) + ")");
  }
  std::sort(names.begin(), names.end(),
            [fractions = have_fractions(names)](const std::string& a, const std::string& b) {
              return natural_less(a, b, fractions);
            });
  return names;
}

std::optional<std::vector<std::string>> scan_of_each_line(const std::vector<std::string>& names,
                                                          std::int64_t lines) {
  if (static_cast<std::size_t>(lines) == names.size()) return names;
  std::vector<std::int64_t> numbers;
  for (const std::string& name : names) {
    const std::optional<std::int64_t> number = number_of(name);
    if (!number || (!numbers.empty() && *number <= numbers.back())) return {};
    numbers.push_back(*number);
  }
  // As many lines as numbers from 0 on, or from the first on.
  const std::int64_t end = numbers.back() + 1;
  if (lines != end && lines != end - numbers.front()) return {};
  const std::int64_t first = lines == end ? 0 : numbers.front();
  std::vector<std::string> scans(static_cast<std::size_t>(lines));
  for (std::size_t i = 0; i < names.size(); ++i) {
    scans[static_cast<std::size_t>(numbers[i] - first)] = names[i];
  }
  return scans;
}

}  // namespace datasets
