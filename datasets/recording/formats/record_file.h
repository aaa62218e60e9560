#pragma once
/// A binary file, read piece by piece (no paper section).
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace datasets {

class RecordFile {
 public:
  /// @throws ldm::InvalidInput if it cannot be read.
  explicit RecordFile(const std::filesystem::path& file);

  /// The next bytes, in `buffer`.
  /// @throws BrokenFrame unless there are so many.
  std::string_view read(std::uint64_t count, std::string& buffer);
  template <class Number>
  Number number() {
    Number value;
    read_into(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  }
  void skip(std::uint64_t count);
  bool at_end() const { return position_ == size_; }
  std::uint64_t size() const { return size_; }
  std::uint64_t position() const { return position_; }
  void go_to(std::uint64_t position);
  /// `file: byte 1234`
  std::string place() const;
  /// The file is damaged, or is none of its kind: nothing behind can be read.
  [[noreturn]] void reject(const std::string& message) const;

 private:
  void read_into(char* to, std::uint64_t count);
  void require(std::uint64_t count) const;

  std::string name_;
  std::ifstream stream_;
  std::uint64_t size_ = 0, position_ = 0;
};

}  // namespace datasets
