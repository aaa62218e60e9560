#include "datasets/recording/scans/number_lines.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>

#include "datasets/files/text.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/date_time.h"

namespace datasets {
namespace {

constexpr std::size_t kLongestShown = 40;

/// The finite number that a word is.
std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  if (!parse_number(word, value) || !std::isfinite(value)) return {};
  return value;
}

bool is_of_words(std::string_view line) {
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    if (number_in(word)) return false;
  }
  return true;
}

/// The date with a time of day that a line is.
std::optional<double> date_time_in(std::string_view line) {
  std::string text(next_word(line));
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    text.append(" ").append(word);
  }
  return seconds_of_date_time(text);
}

bool is_data(std::string_view line) {
  const std::string_view first = next_word(line);
  return !first.empty() && first.front() != '#';
}

}  // namespace

std::unique_ptr<std::istream> open_file(const std::filesystem::path& file) {
  auto stream = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (!*stream) {
    throw ldm::InvalidInput(file.string() + ": cannot be read (" + std::strerror(errno) + ")");
  }
  if (std::filesystem::is_directory(file)) {
    throw ldm::InvalidInput(file.string() + ": is a folder: allowed: a file");
  }
  return stream;
}

NumberLines::NumberLines(const std::filesystem::path& file)
    : NumberLines(open_file(file), file.string()) {}

NumberLines::NumberLines(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {}

bool NumberLines::advance() {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  while (std::getline(*stream_, line_)) {
    ++line_number_;
    if (line_number_ == 1 && line_.starts_with(kByteOrderMark)) {
      line_.erase(0, kByteOrderMark.size());
    }
    if (!is_data(line_)) continue;
    const bool header = !begun_ && is_of_words(line_) && !date_time_in(line_);
    begun_ = true;
    if (!header) return true;
  }
  ++line_number_;
  line_.clear();
  return false;
}

const std::vector<double>& NumberLines::numbers(std::size_t count, const std::string& reason) {
  numbers_.clear();
  std::string_view rest = line_;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    const std::optional<double> value = number_in(word);
    if (!value) {
      reject(reason, std::string(word.substr(0, kLongestShown)) + ": allowed: a finite number");
    }
    numbers_.push_back(*value);
  }
  if (numbers_.size() != count) {
    reject(reason, std::to_string(numbers_.size()) + " numbers: allowed: " + std::to_string(count));
  }
  return numbers_;
}

double NumberLines::time(double unit, const std::string& reason) {
  if (const auto date_time = date_time_in(line_)) return *date_time;
  return unit * numbers(1, reason).front();
}

std::size_t NumberLines::words() const {
  std::size_t count = 0;
  std::string_view rest = line_;
  while (!next_word(rest).empty()) ++count;
  return count;
}

std::string NumberLines::place() const {
  return name_ + ":" + std::to_string(line_number_);
}

void NumberLines::reject(const std::string& reason, const std::string& message) const {
  throw BrokenFrame(reason, place() + ": " + message);
}

std::int64_t count_lines(const std::filesystem::path& file) {
  NumberLines lines(file);
  std::int64_t count = 0;
  while (lines.advance()) ++count;
  return count;
}

}  // namespace datasets
