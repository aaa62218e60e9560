#include "datasets/files/csv.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "datasets/files/text.h"
#include "ldm/types.h"

namespace datasets {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The words between separators, but for those in quotes.
std::vector<std::string_view> split(std::string_view line, char separator, bool quotes) {
  std::vector<std::string_view> values;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (quotes && line[at] == '"') quoted = !quoted;
    if (quoted || line[at] != separator) continue;
    values.push_back(line.substr(begin, at - begin));
    begin = at + 1;
  }
  values.push_back(line.substr(begin));
  return values;
}

/// Without blanks and quotes around it.
std::string_view bare(std::string_view value) {
  const auto trim = [&value](std::string_view around) {
    value.remove_prefix(std::min(value.find_first_not_of(around), value.size()));
    value = value.substr(0, value.find_last_not_of(around) + 1);
  };
  trim(" \t");
  if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
    value = value.substr(1, value.size() - 2);
    trim(" \t");
  }
  return value;
}

/// True if all of `text` is one number, or what other programs write for it: +3, 3.0.
template <class Number>
bool parse_foreign(std::string_view text, Number& number) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  if (parse_number(text, number)) return true;
  double value = 0;
  constexpr double kExact = 9007199254740992;  // 2^53
  if (!parse_number(text, value) || std::trunc(value) != value || std::abs(value) > kExact)
    return false;
  number = static_cast<Number>(value);
  return true;
}

}  // namespace

CsvWriter& CsvWriter::add(std::string_view word) {
  if (row_begun_) out_ << ',';
  out_ << word;
  row_begun_ = true;
  return *this;
}

CsvWriter& CsvWriter::add(double value) {
  return add(std::string_view(decimal(value)));
}

CsvWriter& CsvWriter::add(double value, int decimals) {
  return add(std::string_view(rounded(value, decimals)));
}

CsvWriter& CsvWriter::add(std::int64_t value) {
  return add(std::string_view(std::to_string(value)));
}

void CsvWriter::end_row() {
  out_ << '\n';
  row_begun_ = false;
}

CsvReader::CsvReader(const std::filesystem::path& file) : CsvReader(file, Dialect::kForeign) {}

CsvReader::CsvReader(const std::filesystem::path& file, Dialect dialect)
    : file_(file.string()),
      foreign_(dialect == Dialect::kForeign),
      stream_(file, std::ios::binary) {
  if (!stream_) {
    throw ldm::InvalidInput(file_ + ": cannot be read (" + std::strerror(errno) + ")");
  }
  if (!read_line()) reject("the file is empty; allowed: the names of the columns");
  if (foreign_ && line_.starts_with(kByteOrderMark)) line_.erase(0, kByteOrderMark.size());
  for (const char separator : {';', '\t'}) {
    if (foreign_ && line_.find(',') == std::string::npos &&
        line_.find(separator) != std::string::npos) {
      separator_ = separator;
    }
  }
  split_line();
  for (const std::string_view column : values_) columns_.emplace_back(column);
}

CsvReader::CsvReader(const std::filesystem::path& file, std::string_view header)
    : CsvReader(file, Dialect::kOurs) {
  if (line_ != header) reject("allowed as first line: " + std::string(header));
}

bool CsvReader::read_line() {
  ++line_number_;
  if (!std::getline(stream_, line_)) {
    if (stream_.bad()) reject("cannot be read");
    return false;
  }
  // Without its end, a line may have lost the last digits of its last number.
  if (stream_.eof() && !foreign_) reject("the file ends in the middle of this line");
  if (line_.ends_with('\r')) line_.pop_back();  // of other systems and of spreadsheets
  return true;
}

void CsvReader::split_line() {
  values_ = split(line_, separator_, foreign_);
  if (!foreign_) return;
  for (std::string_view& value : values_) value = bare(value);
}

bool CsvReader::next_row() {
  do {
    if (!read_line()) return false;
    split_line();
  } while (foreign_ && values_.size() == 1 && values_.front().empty());
  next_ = 0;
  if (values_.size() != columns_.size()) {
    reject(std::to_string(values_.size()) + " values, allowed: " + std::to_string(columns_.size()));
  }
  return true;
}

std::string_view CsvReader::next_value() {
  return values_.at(next_++);
}

double CsvReader::number() {
  double value = 0;
  const std::string_view text = next_value();
  if (!(foreign_ ? parse_foreign(text, value) : parse_number(text, value)) ||
      !std::isfinite(value)) {
    reject_value("a finite number");
  }
  return value;
}

std::int64_t CsvReader::integer(std::int64_t min, std::int64_t max) {
  std::int64_t value = 0;
  const std::string_view text = next_value();
  if (!(foreign_ ? parse_foreign(text, value) : parse_number(text, value)) || value < min ||
      value > max) {
    reject_value(min == max
                     ? std::to_string(min)
                     : "an integer in [" + std::to_string(min) + ", " + std::to_string(max) + "]");
  }
  return value;
}

bool CsvReader::boolean() {
  const std::string_view text = values_.at(next_);
  for (const std::string_view word : {"true", "True", "TRUE", "false", "False", "FALSE"}) {
    if (text != word) continue;
    ++next_;
    return word.size() == 4;
  }
  return integer(0, 1) == 1;
}

std::size_t CsvReader::choice(std::span<const std::string_view> words) {
  const auto word = std::find(words.begin(), words.end(), next_value());
  if (word == words.end()) {
    reject_value(joined(words));
  }
  return static_cast<std::size_t>(word - words.begin());
}

void CsvReader::reject(const std::string& message) const {
  throw ldm::InvalidInput(file_ + ":" + std::to_string(line_number_) + ": " + message);
}

void CsvReader::reject_value(const std::string& allowed) const {
  reject(columns_[next_ - 1] + " = " + std::string(values_[next_ - 1]) + ": allowed: " + allowed);
}

}  // namespace datasets
