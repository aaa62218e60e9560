#pragma once
/// Text files with numbers between blanks, as trajectories and time tables are (no paper section).
#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace datasets {

/// Reads such a file line by line; empty lines and those that begin with `#` do not count, nor does
/// a first line of words, or a byte order mark.
class NumberLines {
 public:
  /// @throws ldm::InvalidInput if the file cannot be read.
  explicit NumberLines(const std::filesystem::path& file);
  /// @param name for messages
  NumberLines(std::unique_ptr<std::istream> stream, std::string name);

  /// To the next line; false at the end of the file. Looks at no number: a bad line costs itself.
  bool advance();
  /// The line, without its end.
  const std::string& text() const { return line_; }
  /// Leave out the first `count` characters of the line.
  void drop(std::size_t count) { line_.erase(0, count); }
  /// The numbers of the line; all must be finite.
  /// @param reason under which a bad line is counted
  /// @throws BrokenFrame unless there are that many of them.
  const std::vector<double>& numbers(std::size_t count, const std::string& reason);
  /// The time that the line is: a number of `unit` [s], or a date with a time of day. [s]
  /// @throws BrokenFrame, as `numbers` does, if it is none.
  double time(double unit, const std::string& reason);
  /// How many words the line has.
  std::size_t words() const;
  /// `file:line`, or the line after the last.
  std::string place() const;
  /// @throws BrokenFrame `file:line: message`
  [[noreturn]] void reject(const std::string& reason, const std::string& message) const;

 private:
  std::unique_ptr<std::istream> stream_;
  std::string name_;
  std::int64_t line_number_ = 0;
  bool begun_ = false;  // a line that counts, or one of words, was there
  std::string line_;
  std::vector<double> numbers_;
};

/// Number of such lines in a file.
/// @throws ldm::InvalidInput if it cannot be read.
std::int64_t count_lines(const std::filesystem::path& file);

/// A file open for reading.
/// @throws ldm::InvalidInput if it cannot be read or is a folder.
std::unique_ptr<std::istream> open_file(const std::filesystem::path& file);

}  // namespace datasets
