#include "datasets/pcd_file.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "datasets/broken_frame.h"
#include "datasets/pcd_header.h"

namespace datasets {
namespace {

constexpr char kBroken[] = "broken scan";

template <class T>
float number_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<float>(value);
}

float number_at(const char* bytes, const PcdHeader::Field& field) {
  switch (field.type) {
    case 'F':
      return field.size == 4 ? number_at<float>(bytes) : number_at<double>(bytes);
    case 'I':
      if (field.size == 1) return number_at<std::int8_t>(bytes);
      if (field.size == 2) return number_at<std::int16_t>(bytes);
      return field.size == 4 ? number_at<std::int32_t>(bytes) : number_at<std::int64_t>(bytes);
    default:
      if (field.size == 1) return number_at<std::uint8_t>(bytes);
      if (field.size == 2) return number_at<std::uint16_t>(bytes);
      return field.size == 4 ? number_at<std::uint32_t>(bytes) : number_at<std::uint64_t>(bytes);
  }
}

/// Where field `axis` of point 0 begins, and how far it is to that of the next point.
struct Stride {
  std::size_t begin, step;
};

/// @param strides of x, y, z in `data`, which is long enough
void take(std::string_view data, const PcdHeader& header, const Stride (&strides)[3],
          std::vector<ldm::Point>& points) {
  points.reserve(points.size() + header.points);
  for (std::size_t i = 0; i < header.points; ++i) {
    ldm::Point p;
    for (int axis = 0; axis < 3; ++axis) {
      const Stride& stride = strides[axis];
      p[axis] = number_at(data.data() + stride.begin + i * stride.step, header.xyz[axis]);
    }
    points.push_back(p);
  }
}

[[noreturn]] void reject_size(const std::string& name, std::size_t byte, std::size_t bytes,
                              std::size_t expected) {
  throw BrokenFrame(kBroken, name + ": byte " + std::to_string(byte) + ": " +
                                 std::to_string(bytes) + " bytes of points follow: allowed: " +
                                 std::to_string(expected) + ", as the header says");
}

/// The first `size` bytes of what follows the header. PCL pads its files with zeros; other bytes
/// behind the points say that the header is not theirs.
/// @param byte at which `data` begins in the file
std::string_view exactly(std::string_view data, std::size_t size, const std::string& name,
                         std::size_t byte) {
  const bool longer =
      data.size() > size && data.find_first_not_of('\0', size) != std::string_view::npos;
  if (data.size() < size || longer) reject_size(name, byte, data.size(), size);
  return data.substr(0, size);
}

void take_binary(std::string_view data, const PcdHeader& header, const std::string& name,
                 std::vector<ldm::Point>& points) {
  data = exactly(data, header.points * header.point_size, name, header.data_begin);
  Stride strides[3];
  for (int i = 0; i < 3; ++i) strides[i] = {header.xyz[i].offset, header.point_size};
  take(data, header, strides, points);
}

/// Two sizes, then the fields one after the other, compressed.
void take_compressed(std::string_view data, const PcdHeader& header, const std::string& name,
                     std::vector<ldm::Point>& points) {
  std::uint32_t sizes[2] = {0, 0};  // compressed, uncompressed
  if (data.size() < sizeof sizes) {
    reject_size(name, header.data_begin, data.size(), sizeof sizes);
  }
  std::memcpy(sizes, data.data(), sizeof sizes);
  data.remove_prefix(sizeof sizes);
  const std::size_t begin = header.data_begin + sizeof sizes;
  data = exactly(data, sizes[0], name, begin);
  const std::size_t expected = header.points * header.point_size;
  if (sizes[1] != expected) {
    throw BrokenFrame(kBroken, name + ": byte " + std::to_string(header.data_begin + 4) +
                                   ": uncompressed size " + std::to_string(sizes[1]) +
                                   ": allowed: " + std::to_string(expected) +
                                   ", as the header says");
  }
  if (expected == 0) return;
  // Three bytes stand for at most 264: a small file cannot ask for much memory.
  constexpr std::size_t kHighestRatio = 100;
  const bool plausible = expected / kHighestRatio <= sizes[0];
  std::string plain(plausible ? expected : 0, '\0');
  if (!plausible || lzf_decompress(data.data(), sizes[0], plain.data(), sizes[1]) != sizes[1]) {
    throw BrokenFrame(
        kBroken, name + ": byte " + std::to_string(begin) + ": the compressed points are damaged");
  }
  Stride strides[3];
  for (int i = 0; i < 3; ++i) {
    strides[i] = {header.xyz[i].offset * header.points, header.xyz[i].size};
  }
  take(plain, header, strides, points);
}

/// Reads the points of an ascii file, a line each.
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
      if (words_.find_first_not_of(kBlanks) != std::string_view::npos) return true;
    }
    ++line_;
    return false;
  }

  ldm::Point point() {
    ldm::Point p;
    std::size_t column = 0;
    for (std::string_view word = next_word(); !word.empty(); word = next_word(), ++column) {
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

  std::string_view next_word() {
    words_.remove_prefix(std::min(words_.find_first_not_of(kBlanks), words_.size()));
    const std::string_view word = words_.substr(0, words_.find_first_of(kBlanks));
    words_.remove_prefix(word.size());
    return word;
  }

  float number(std::string_view word) const {
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [read, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc{} || read != end) {
      reject(std::string(word.substr(0, 40)) + ": allowed: a number or nan");
    }
    return static_cast<float>(value);
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

void parse_pcd(std::string_view content, const std::string& name, std::vector<ldm::Point>& points) {
  const PcdHeader header = parse_pcd_header(content, name);
  const std::string_view data = content.substr(header.data_begin);
  switch (header.encoding) {
    case PcdHeader::Encoding::kAscii:
      AsciiPoints(data, header, name).take(points);
      break;
    case PcdHeader::Encoding::kBinary:
      take_binary(data, header, name, points);
      break;
    case PcdHeader::Encoding::kBinaryCompressed:
      take_compressed(data, header, name, points);
      break;
  }
}

}  // namespace datasets
