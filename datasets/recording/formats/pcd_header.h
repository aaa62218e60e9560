#pragma once
/// The header of a PCD file (no paper section).
#include <cstdint>
#include <string>
#include <string_view>

namespace datasets {

struct PcdHeader {
  enum class Encoding : std::uint8_t { kAscii, kBinary, kBinaryCompressed };
  /// One of the fields x, y, z.
  struct Field {
    char type = 'F';         ///< I, U or F
    std::size_t size = 0;    ///< of one number [bytes]
    std::size_t offset = 0;  ///< in a point [bytes]
    std::size_t column = 0;  ///< position among the words of a line in ascii
  };
  Field xyz[3];
  std::size_t point_size = 0;  ///< of all fields [bytes]
  std::size_t columns = 0;     ///< words of a line in ascii
  std::size_t points = 0;
  Encoding encoding = Encoding::kAscii;
  std::size_t data_begin = 0;  ///< of the points in the file [bytes]
  std::int64_t lines = 0;      ///< of the header
};

/// @throws BrokenFrame `name:line: ...` on a header that is cut short, lacks an entry, or
/// contradicts itself; sizes are bounded such that point_size * points cannot overflow.
PcdHeader parse_pcd_header(std::string_view content, const std::string& name);

}  // namespace datasets
