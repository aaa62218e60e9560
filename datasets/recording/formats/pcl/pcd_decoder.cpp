#include "datasets/recording/formats/pcd_decoder.h"

#include <locale.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>

namespace datasets {
namespace {

using Field = pcl::PCLPointField;

template <class T>
float number_at(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<float>(value);
}

float number_at(const std::uint8_t* bytes, std::uint8_t type) {
  switch (type) {
    case Field::INT8:
      return number_at<std::int8_t>(bytes);
    case Field::UINT8:
      return number_at<std::uint8_t>(bytes);
    case Field::INT16:
      return number_at<std::int16_t>(bytes);
    case Field::UINT16:
      return number_at<std::uint16_t>(bytes);
    case Field::INT32:
      return number_at<std::int32_t>(bytes);
    case Field::UINT32:
      return number_at<std::uint32_t>(bytes);
    case Field::INT64:
      return number_at<std::int64_t>(bytes);
    case Field::UINT64:
      return number_at<std::uint64_t>(bytes);
    case Field::FLOAT32:
      return number_at<float>(bytes);
    default:
      return number_at<double>(bytes);
  }
}

/// While it lives, numbers of this thread have a decimal point: PCL reads them by atof, to which
/// the user's language matters as soon as a window's library (GTK) has set it.
class DecimalPoint {
 public:
  DecimalPoint() : classic_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(classic_)) {}
  ~DecimalPoint() {
    uselocale(before_);
    freelocale(classic_);
  }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

 private:
  locale_t classic_, before_;
};

/// What PCL fills. It is told of x, y and z alone, and how much lies between them: what a header
/// says of the other fields cannot mislead it.
class Cloud {
 public:
  explicit Cloud(const PcdHeader& header) : encoding_(header.encoding) {
    std::array<int, 3> axes = {0, 1, 2};
    std::sort(axes.begin(), axes.end(),
              [&](int a, int b) { return header.xyz[a].offset < header.xyz[b].offset; });
    if (encoding_ == PcdHeader::Encoding::kAscii) {
      describe_columns(header, axes);
    } else {
      describe_bytes(header, axes);
    }
    cloud_.width = static_cast<pcl::uindex_t>(header.points);
    cloud_.height = 1;
    cloud_.data.resize(header.points * cloud_.point_step);
  }

  bool read(std::string_view body) {
    pcl::PCDReader reader;
    if (encoding_ == PcdHeader::Encoding::kAscii) {
      const DecimalPoint decimal_point;
      std::istringstream lines{std::string(body)};
      return reader.readBodyASCII(lines, cloud_, pcl::PCDReader::PCD_V7) == 0;
    }
    const bool compressed = encoding_ == PcdHeader::Encoding::kBinaryCompressed;
    return reader.readBodyBinary(reinterpret_cast<const unsigned char*>(body.data()), cloud_,
                                 pcl::PCDReader::PCD_V7, compressed, 0) == 0;
  }

  void take(std::vector<ldm::Point>& points) const {
    points.reserve(points.size() + cloud_.width);
    for (std::size_t i = 0; i < cloud_.width; ++i) {
      const std::uint8_t* const bytes = cloud_.data.data() + i * cloud_.point_step;
      ldm::Point p;
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = number_at(bytes + xyz_[axis].offset, xyz_[axis].datatype);
      }
      points.push_back(p);
    }
  }

 private:
  void add(const char* name, int type, std::size_t count) {
    cloud_.fields.push_back({name, cloud_.point_step, static_cast<std::uint8_t>(type),
                             static_cast<pcl::uindex_t>(count)});
    cloud_.point_step +=
        static_cast<pcl::uindex_t>(count) * static_cast<pcl::uindex_t>(pcl::getFieldSize(type));
  }

  void add_axis(int axis, int type) {
    add("xyz", type, 1);
    xyz_[axis] = cloud_.fields.back();
  }

  /// As double, whatever the header says: into one byte PCL would squeeze 300, and cut 2.5 to 2.
  /// Columns of fields named "_" it passes over.
  void describe_columns(const PcdHeader& header, const std::array<int, 3>& axes) {
    std::size_t column = 0;
    const auto skip_to = [&](std::size_t next) {
      cloud_.fields.push_back({"_", 0, Field::UINT8, static_cast<pcl::uindex_t>(next - column)});
    };
    for (const int axis : axes) {
      skip_to(header.xyz[axis].column);
      add_axis(axis, Field::FLOAT64);
      column = header.xyz[axis].column + 1;
    }
    skip_to(header.columns);
  }

  /// No field is named "_": PCL holds that compressed files leave those out.
  void describe_bytes(const PcdHeader& header, const std::array<int, 3>& axes) {
    for (const int axis : axes) {
      const PcdHeader::Field& field = header.xyz[axis];
      add("other", Field::UINT8, field.offset - cloud_.point_step);
      add_axis(axis, pcl::getFieldType(static_cast<int>(field.size), field.type));
    }
    add("other", Field::UINT8, header.point_size - cloud_.point_step);
  }

  PcdHeader::Encoding encoding_;
  pcl::PCLPointCloud2 cloud_;
  std::array<Field, 3> xyz_;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) bool ldm_decode_pcd(
    const PcdHeader& header, std::string_view body, std::vector<ldm::Point>& points) {
  static const bool silent = [] {  // the reader's caller says what is wrong
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    return true;
  }();
  static_cast<void>(silent);
  Cloud cloud(header);
  if (!cloud.read(body)) return false;
  cloud.take(points);
  return true;
}

}  // namespace datasets
