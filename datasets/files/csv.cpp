#include "datasets/files/csv.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "datasets/files/toml_node.h"
#include "ldm/types.h"

namespace datasets {
namespace {

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> values;
  for (;;) {
    const std::size_t comma = line.find(',');
    values.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return values;
    line.remove_prefix(comma + 1);
  }
}

/// True if all of `text` is one number.
template <class Number>
bool parse(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

CsvWriter::CsvWriter(const std::filesystem::path& file, std::string_view header)
    : file_(file), stream_(file, std::ios::binary | std::ios::trunc) {
  if (!stream_) {
    throw ldm::InvalidInput(file.string() + ": cannot be written (" + std::strerror(errno) + ")");
  }
  stream_ << header << '\n';
}

CsvWriter& CsvWriter::add(std::string_view word) {
  if (row_begun_) stream_ << ',';
  stream_ << word;
  row_begun_ = true;
  return *this;
}

CsvWriter& CsvWriter::add(double value) {
  return add(std::string_view(decimal(value)));
}

CsvWriter& CsvWriter::add(std::int64_t value) {
  return add(std::string_view(std::to_string(value)));
}

void CsvWriter::end_row() {
  stream_ << '\n';
  row_begun_ = false;
}

void CsvWriter::close() {
  stream_.close();
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written: disk full?");
}

CsvReader::CsvReader(const std::filesystem::path& file)
    : file_(file.string()), stream_(file, std::ios::binary) {
  if (!stream_) {
    throw ldm::InvalidInput(file_ + ": cannot be read (" + std::strerror(errno) + ")");
  }
  if (!read_line()) reject("the file is empty; allowed: the names of the columns");
  for (const std::string_view column : split(line_)) columns_.emplace_back(column);
}

CsvReader::CsvReader(const std::filesystem::path& file, std::string_view header) : CsvReader(file) {
  if (line_ != header) reject("allowed as first line: " + std::string(header));
}

bool CsvReader::read_line() {
  ++line_number_;
  if (!std::getline(stream_, line_)) {
    if (stream_.bad()) reject("cannot be read");
    return false;
  }
  // Without its end, a line may have lost the last digits of its last number.
  if (stream_.eof()) reject("the file ends in the middle of this line");
  if (line_.ends_with('\r')) line_.pop_back();  // of other systems and of spreadsheets
  return true;
}

bool CsvReader::next_row() {
  if (!read_line()) return false;
  values_ = split(line_);
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
  if (!parse(next_value(), value) || !std::isfinite(value)) reject_value("a finite number");
  return value;
}

std::int64_t CsvReader::integer(std::int64_t min, std::int64_t max) {
  std::int64_t value = 0;
  if (!parse(next_value(), value) || value < min || value > max) {
    reject_value(min == max
                     ? std::to_string(min)
                     : "an integer in [" + std::to_string(min) + ", " + std::to_string(max) + "]");
  }
  return value;
}

std::size_t CsvReader::choice(std::span<const std::string_view> words) {
  const auto word = std::find(words.begin(), words.end(), next_value());
  if (word == words.end()) {
    std::string allowed(words.front());
    for (const std::string_view other : words.subspan(1)) allowed.append(", ").append(other);
    reject_value(allowed);
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
