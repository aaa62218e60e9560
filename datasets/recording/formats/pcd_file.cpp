#include "datasets/recording/formats/pcd_file.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "datasets/files/text.h"
#include "datasets/recording/formats/pcd_header.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {
namespace {

constexpr char kBroken[] = "broken scan";

template <class T>
float number_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<float>(value);
}

using NumberAt = float (*)(const char* bytes);

NumberAt number_of(const PcdHeader::Field& field) {
  switch (field.type) {
    case 'F':
      return field.size == 4 ? number_at<float> : number_at<double>;
    case 'I':
      if (field.size == 1) return number_at<std::int8_t>;
      if (field.size == 2) return number_at<std::int16_t>;
      return field.size == 4 ? number_at<std::int32_t> : number_at<std::int64_t>;
    default:
      if (field.size == 1) return number_at<std::uint8_t>;
      if (field.size == 2) return number_at<std::uint16_t>;
      return field.size == 4 ? number_at<std::uint32_t> : number_at<std::uint64_t>;
  }
}

/// One axis of all points: where point 0 has it, and how far it is to that of the next point
/// [bytes].
struct Column {
  NumberAt number;
  std::size_t begin, step;
};

/// @param data all points, as long as the header says
void take(std::string_view data, std::size_t count, const Column (&xyz)[3],
          std::vector<ldm::Point>& points) {
  points.reserve(points.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    ldm::Point p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = xyz[axis].number(data.data() + xyz[axis].begin + i * xyz[axis].step);
    }
    points.push_back(p);
  }
}

/// The binary points of a file, which begin at `byte`.
class BinaryPoints {
 public:
  BinaryPoints(std::string_view data, const PcdHeader& header, const std::string& name)
      : data_(data), header_(header), name_(name), byte_(header.data_begin) {}

  void take(std::vector<ldm::Point>& points) {
    const std::string_view data = exactly(header_.points * header_.point_size);
    Column xyz[3];
    for (int i = 0; i < 3; ++i) {
      xyz[i] = {number_of(header_.xyz[i]), header_.xyz[i].offset, header_.point_size};
    }
    datasets::take(data, header_.points, xyz, points);
  }

  /// Two sizes, then the fields one after the other, compressed.
  void take_compressed(std::vector<ldm::Point>& points) {
    std::uint32_t sizes[2] = {0, 0};  // compressed, uncompressed
    if (data_.size() < sizeof sizes) reject_size(sizeof sizes);
    std::memcpy(sizes, data_.data(), sizeof sizes);
    data_.remove_prefix(sizeof sizes);
    byte_ += sizeof sizes;
    const std::string_view data = exactly(sizes[0]);
    const std::size_t size = header_.points * header_.point_size;
    if (sizes[1] != size) {
      reject(byte_ - sizeof sizes[1], "uncompressed size " + std::to_string(sizes[1]) +
                                          ": allowed: " + std::to_string(size) +
                                          ", as the header says");
    }
    if (size == 0) return;
    // Three bytes stand for at most 264: a small file cannot ask for much memory.
    constexpr std::size_t kHighestRatio = 100;
    const bool plausible = size / kHighestRatio < sizes[0];
    std::string plain(plausible ? size : 0, '\0');
    if (!plausible || lzf_decompress(data.data(), sizes[0], plain.data(), sizes[1]) != sizes[1]) {
      reject(byte_, "the compressed points are damaged");
    }
    Column xyz[3];
    for (int i = 0; i < 3; ++i) {
      const PcdHeader::Field& field = header_.xyz[i];
      xyz[i] = {number_of(field), field.offset * header_.points, field.size};
    }
    datasets::take(plain, header_.points, xyz, points);
  }

 private:
  /// The first `size` bytes. PCL pads its files with zeros, and an editor ends them with a line;
  /// other bytes behind the points say that the header is not theirs.
  std::string_view exactly(std::size_t size) const {
    if (data_.size() < size) reject_size(size);
    std::string_view rest = data_.substr(size);
    rest = rest.substr(0, rest.find_last_not_of('\0') + 1);
    if (!rest.empty() && rest != "\n" && rest != "\r\n") reject_size(size);
    return data_.substr(0, size);
  }

  [[noreturn]] void reject_size(std::size_t expected) const {
    reject(byte_, std::to_string(data_.size()) + " bytes of points follow: allowed: " +
                      std::to_string(expected) + ", as the header says");
  }

  [[noreturn]] void reject(std::size_t byte, const std::string& message) const {
    throw BrokenFrame(kBroken, name_ + ": byte " + std::to_string(byte) + ": " + message);
  }

  std::string_view data_;
  const PcdHeader& header_;
  const std::string& name_;
  std::size_t byte_;
};

/// The points of an ascii file, a line each.
class AsciiPoints {
 public:
  AsciiPoints(std::string_view data, const PcdHeader& header, const std::string& name)
      : rest_(data), header_(header), name_(name), line_(header.lines) {}

  void take(std::vector<ldm::Point>& points) {
    for (std::size_t i = 0; i < header_.points; ++i) {
      if (!next_line()) {
        reject("the file ends: allowed: " + std::to_string(header_.points) +
               " points, as the header says");
      }
      points.push_back(point());
    }
    if (next_line()) reject("a line too many: the header says otherwise");
  }

 private:
  /// To the next line that is not empty.
  bool next_line() {
    while (!rest_.empty()) {
      ++line_;
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      words_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (std::string_view line = words_; !next_word(line).empty()) return true;
    }
    ++line_;
    return false;
  }

  ldm::Point point() {
    ldm::Point p;
    std::size_t column = 0;
    for (std::string_view word = next_word(words_); !word.empty();
         word = next_word(words_), ++column) {
      for (int axis = 0; axis < 3; ++axis) {
        if (column == header_.xyz[axis].column) p[axis] = number(word);
      }
    }
    if (column != header_.columns) {
      reject(std::to_string(column) + " values: allowed: " + std::to_string(header_.columns) +
             ", as the header says");
    }
    return p;
  }

  /// What is written, whatever the type of its field: PCL would squeeze 300 into one byte.
  float number(std::string_view word) const {
    const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    double value = 0;
    if (!parse_number(word.substr(plus), value)) {
      reject(std::string(word.substr(0, 40)) + ": allowed: a number or nan");
    }
    return static_cast<float>(value);
  }

  [[noreturn]] void reject(const std::string& message) const {
    throw BrokenFrame(kBroken, name_ + ":" + std::to_string(line_) + ": " + message);
  }

  std::string_view rest_, words_;
  const PcdHeader& header_;
  const std::string& name_;
  std::int64_t line_;
};

}  // namespace

void parse_pcd(std::string_view content, const std::string& name, std::vector<ldm::Point>& points) {
  const PcdHeader header = parse_pcd_header(content, name);
  const std::string_view data = content.substr(header.data_begin);
  switch (header.encoding) {
    case PcdHeader::Encoding::kAscii:
      return AsciiPoints(data, header, name).take(points);
    case PcdHeader::Encoding::kBinary:
      return BinaryPoints(data, header, name).take(points);
    case PcdHeader::Encoding::kBinaryCompressed:
      return BinaryPoints(data, header, name).take_compressed(points);
  }
}

}  // namespace datasets
