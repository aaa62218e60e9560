#pragma once
/// Tables of numbers as text: strict reading, numbers that read back to the same bits (no paper
/// section).
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace datasets {

/// Rows into a stream, which the caller checks.
class CsvWriter {
 public:
  /// Write `header` as the first line.
  CsvWriter(std::ostream& out, std::string_view header) : out_(out) { out_ << header << '\n'; }

  CsvWriter& add(double value);
  /// Rounded to so many decimals.
  CsvWriter& add(double value, int decimals);
  CsvWriter& add(std::int64_t value);
  /// A word without comma or line break.
  CsvWriter& add(std::string_view word);
  /// Three numbers.
  template <class Vector, class... Decimals>
  CsvWriter& add_vector(const Vector& v, Decimals... decimals) {
    for (int i = 0; i < 3; ++i) add(static_cast<double>(v[i]), decimals...);
    return *this;
  }
  void end_row();

 private:
  std::ostream& out_;
  bool row_begun_ = false;
};

/// Reads row by row. Every error is an `ldm::InvalidInput` that says file, line and column.
class CsvReader {
 public:
  /// @throws ldm::InvalidInput if the file cannot be read or its first line is not `header`.
  CsvReader(const std::filesystem::path& file, std::string_view header);
  /// A table of another program, with the columns that its first line names, in any order: values
  /// between commas, semicolons or tabs, in quotes or not, with blanks around them or lines without
  /// any; a byte order mark before, no line end behind; whole numbers as 3.0, signs as +3.
  explicit CsvReader(const std::filesystem::path& file);

  const std::vector<std::string>& columns() const { return columns_; }
  /// Let the next value of the row be that of a column, by its position.
  void go_to(std::size_t column) { next_ = column; }
  /// False at the end of the file.
  /// @throws ldm::InvalidInput on a row of another length than the header, or cut short.
  bool next_row();
  /// The next value of the row, which must be finite.
  double number();
  /// The next value of the row, which must lie in [min, max].
  std::int64_t integer(std::int64_t min, std::int64_t max);
  /// The next value of the row: 0, 1, true or false.
  bool boolean();
  /// The next value of the row, as its position in `words`.
  std::size_t choice(std::span<const std::string_view> words);
  /// Throws ldm::InvalidInput: `file:line: message`.
  [[noreturn]] void reject(const std::string& message) const;

 private:
  enum class Dialect { kOurs, kForeign };
  CsvReader(const std::filesystem::path& file, Dialect dialect);
  bool read_line();
  void split_line();
  std::string_view next_value();
  [[noreturn]] void reject_value(const std::string& allowed) const;

  std::string file_;
  bool foreign_;  // of another program
  char separator_ = ',';
  std::ifstream stream_;
  std::int64_t line_number_ = 0;
  std::string line_;
  std::vector<std::string> columns_;
  std::vector<std::string_view> values_;  // of line_
  std::size_t next_ = 0;                  // position in values_
};

}  // namespace datasets
