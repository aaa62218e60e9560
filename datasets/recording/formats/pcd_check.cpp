#include "datasets/recording/formats/pcd_check.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace datasets {
namespace {

constexpr char kBroken[] = "broken scan";
constexpr std::size_t kCompressedSizes = 8;  // two numbers before the compressed points [bytes]

[[noreturn]] void reject_size(const std::string& name, std::size_t byte, std::size_t bytes,
                              std::size_t expected) {
  throw BrokenFrame(kBroken, name + ": byte " + std::to_string(byte) + ": " +
                                 std::to_string(bytes) + " bytes of points follow: allowed: " +
                                 std::to_string(expected) + ", as the header says");
}

/// PCL pads its files with zeros; other bytes behind the points say that the header is not theirs.
/// @param byte at which `data` begins in the file
void check_size(std::string_view data, std::size_t size, const std::string& name,
                std::size_t byte) {
  const bool longer =
      data.size() > size && data.find_first_not_of('\0', size) != std::string_view::npos;
  if (data.size() < size || longer) reject_size(name, byte, data.size(), size);
}

/// Two sizes, then the fields one after the other, compressed.
void check_compressed(std::string_view data, const PcdHeader& header, const std::string& name) {
  std::uint32_t sizes[2] = {0, 0};  // compressed, uncompressed
  static_assert(sizeof sizes == kCompressedSizes);
  if (data.size() < sizeof sizes) {
    reject_size(name, header.data_begin, data.size(), sizeof sizes);
  }
  std::memcpy(sizes, data.data(), sizeof sizes);
  data.remove_prefix(sizeof sizes);
  check_size(data, sizes[0], name, header.data_begin + sizeof sizes);
  const std::size_t expected = header.points * header.point_size;
  if (sizes[1] != expected) {
    throw BrokenFrame(kBroken, name + ": byte " + std::to_string(header.data_begin + 4) +
                                   ": uncompressed size " + std::to_string(sizes[1]) +
                                   ": allowed: " + std::to_string(expected) +
                                   ", as the header says");
  }
  // Three bytes stand for at most 264: a small file cannot ask for much memory. None stand for
  // nothing, and PCL would read one.
  constexpr std::size_t kHighestRatio = 100;
  if (expected > 0 && expected / kHighestRatio >= sizes[0]) throw damaged_points(header, name);
}

/// The lines of an ascii file, one for each point.
class AsciiLines {
 public:
  AsciiLines(std::string_view data, const PcdHeader& header, const std::string& name)
      : rest_(data), header_(header), name_(name), line_(header.lines) {}

  std::string take() {
    std::string lines;
    lines.reserve(rest_.size() + 1);
    for (std::size_t i = 0; i < header_.points; ++i) {
      if (!next_line()) {
        reject("the file ends: allowed: " + std::to_string(header_.points) +
               " points, as the header says");
      }
      lines.append(words_).push_back('\n');
      check_words();
    }
    if (next_line()) reject("a line too many: the header says otherwise");
    return lines;
  }

 private:
  /// To the next line that is not empty.
  bool next_line() {
    while (!rest_.empty()) {
      ++line_;
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      words_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (words_.find_first_not_of(kBlanks) != std::string_view::npos) return true;
    }
    ++line_;
    return false;
  }

  void check_words() {
    std::size_t column = 0;
    for (std::string_view word = next_word(); !word.empty(); word = next_word(), ++column) {
      for (const PcdHeader::Field& field : header_.xyz) {
        if (column == field.column) check_number(word);
      }
    }
    if (column != header_.columns) {
      reject(std::to_string(column) + " values: allowed: " + std::to_string(header_.columns) +
             ", as the header says");
    }
  }

  std::string_view next_word() {
    words_.remove_prefix(std::min(words_.find_first_not_of(kBlanks), words_.size()));
    const std::string_view word = words_.substr(0, words_.find_first_of(kBlanks));
    words_.remove_prefix(word.size());
    return word;
  }

  void check_number(std::string_view word) const {
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [read, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc{} || read != end) {
      reject(std::string(word.substr(0, 40)) + ": allowed: a number or nan");
    }
  }

  [[noreturn]] void reject(const std::string& message) const {
    throw BrokenFrame(kBroken, name_ + ":" + std::to_string(line_) + ": " + message);
  }

  static constexpr std::string_view kBlanks = " \t\r";
  std::string_view rest_, words_;
  const PcdHeader& header_;
  const std::string& name_;
  std::int64_t line_;
};

}  // namespace

std::string checked_lines(std::string_view body, const PcdHeader& header, const std::string& name) {
  return AsciiLines(body, header, name).take();
}

void check_bytes(std::string_view body, const PcdHeader& header, const std::string& name) {
  if (header.encoding == PcdHeader::Encoding::kBinaryCompressed) {
    check_compressed(body, header, name);
  } else {
    check_size(body, header.points * header.point_size, name, header.data_begin);
  }
}

BrokenFrame damaged_points(const PcdHeader& header, const std::string& name) {
  return {kBroken, name + ": byte " + std::to_string(header.data_begin + kCompressedSizes) +
                       ": the compressed points are damaged"};
}

}  // namespace datasets
