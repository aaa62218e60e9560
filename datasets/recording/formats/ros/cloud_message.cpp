#include "datasets/recording/formats/ros/cloud_message.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/files/printable.h"

namespace datasets {
namespace {

constexpr std::string_view kPointCloud = "sensor_msgs/PointCloud2";
constexpr double kLongestDelay = 2;  // [s]

/// sensor_msgs/PointField
struct Field {
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t type = 0;
};
enum FieldType : std::uint8_t { kUint32 = 6, kFloat = 7, kDouble = 8 };
constexpr std::array<std::size_t, 9> kSizes = {0, 1, 1, 2, 2, 4, 4, 4, 8};

template <class Number>
double at(const char* place) {
  Number value;
  std::memcpy(&value, place, sizeof value);
  return static_cast<double>(value);
}
double number_of(const Field& field, const char* point) {
  const char* const place = point + field.offset;
  switch (field.type) {
    case kUint32:
      return at<std::uint32_t>(place);
    case kFloat:
      return at<float>(place);
    default:
      return at<double>(place);
  }
}

/// A PointCloud2 but for its header.
struct Layout {
  std::uint64_t height = 0, width = 0, point_step = 0, row_step = 0;
  bool big_endian = false;
  std::vector<Field> fields;
  std::string_view data;

  const Field* find(std::string_view name) const {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
    return found == fields.end() ? nullptr : &*found;
  }
  template <class Take>
  void for_each_point(Take&& take) const {
    for (std::uint64_t row = 0; row < height; ++row) {
      for (std::uint64_t column = 0; column < width; ++column) {
        take(data.data() + row * row_step + column * point_step);
      }
    }
  }
};

Layout read_layout(MessageFields& fields) {
  Layout layout;
  layout.height = fields.number<std::uint32_t>();
  layout.width = fields.number<std::uint32_t>();
  const auto count = fields.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    Field field;
    field.name = printable(fields.text());
    field.offset = fields.number<std::uint32_t>();
    field.type = fields.number<std::uint8_t>();
    fields.number<std::uint32_t>();  // how many
    layout.fields.push_back(std::move(field));
  }
  layout.big_endian = fields.number<std::uint8_t>() != 0;
  layout.point_step = fields.number<std::uint32_t>();
  layout.row_step = fields.number<std::uint32_t>();
  layout.data = fields.bytes();
  // Some drivers leave it 0, or forget it when they leave out points.
  if (layout.height == 1) layout.row_step = layout.width * layout.point_step;
  return layout;
}

std::string failure_of(const Layout& layout) {
  if (layout.big_endian) return "points in big-endian order: allowed: little-endian";
  for (const char* name : {"x", "y", "z"}) {
    const Field* const field = layout.find(name);
    if (field == nullptr) return "no field " + std::string(name) + ": allowed: x, y and z";
    if (field->type != kFloat && field->type != kDouble) {
      return "field " + field->name + " of type " + std::to_string(field->type) +
             ": allowed: 7 (32-bit float) or 8 (64-bit)";
    }
  }
  for (const Field& field : layout.fields) {
    const bool used = field.type < kSizes.size();
    if (used && field.offset + std::uint64_t{kSizes[field.type]} > layout.point_step) {
      return "field " + field.name + " behind the " + std::to_string(layout.point_step) +
             " bytes of a point";
    }
  }
  if (layout.height == 0 || layout.width == 0) return {};
  if (layout.row_step < layout.width * layout.point_step ||
      (layout.height - 1) > layout.data.size() / std::max<std::uint64_t>(layout.row_step, 1) ||
      (layout.height - 1) * layout.row_step + layout.width * layout.point_step >
          layout.data.size()) {
    return std::to_string(layout.data.size()) +
           " bytes of points: allowed: " + std::to_string(layout.height) + " rows of " +
           std::to_string(layout.width) + " points";
  }
  return {};
}

/// The field with the times of the points, if there is one.
const Field* time_field(const Layout& layout) {
  for (const char* name : {"t", "time", "timestamp", "offset_time", "time_offset"}) {
    const Field* const field = layout.find(name);
    if (field != nullptr && field->type >= kUint32 && field->type <= kDouble) return field;
  }
  return nullptr;
}

/// Numbers of points become seconds after the stamp.
std::string set_delays(const std::vector<double>& times, const Field& field, CloudMessage& cloud) {
  cloud.delays.clear();
  if (times.empty()) return {};
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  if (*first == *last) return {};  // all at once
  // Ouster's and Livox's are nanoseconds, however short a part of a sweep the cloud is.
  const bool nanoseconds =
      field.type == kUint32 && *last - *first <= kLongestDelay * 1e9 && *last - *first > 2e6;
  const std::optional<double> unit = nanoseconds ? 1e-9 : unit_of_sweep(*last - *first);
  const std::string name = "times of points in the field " + field.name;
  constexpr char kAdvice[] = ": allowed: --set input.deskew=false";
  if (!unit) return name + " are spread over " + std::to_string(*last - *first) + kAdvice;
  // Of the stamp's clock: those named so, and those that can be no delays.
  const double stamp = cloud.header.stamp, begin = *first * *unit;
  const bool clock = std::abs(begin - stamp) <= kLongestDelay &&
                     (field.name == "timestamp" || std::abs(begin) > kLongestDelay);
  const double zero = clock ? stamp : 0;
  for (const double time : times) {
    cloud.delays.push_back(static_cast<float>(time * *unit - zero));
    if (!(std::abs(cloud.delays.back()) <= kLongestDelay)) {
      return name + " lie more than " + std::to_string(static_cast<int>(kLongestDelay)) +
             " s from the stamp" + kAdvice;
    }
  }
  return {};
}

std::string read_point_cloud(MessageFields fields, bool with_delays, CloudMessage& cloud) {
  cloud.header = fields.header();
  const Layout layout = read_layout(fields);
  if (std::string failure = failure_of(layout); !failure.empty()) return failure;
  const Field &x = *layout.find("x"), &y = *layout.find("y"), &z = *layout.find("z");
  layout.for_each_point([&](const char* point) {
    cloud.points.emplace_back(number_of(x, point), number_of(y, point), number_of(z, point));
  });
  const Field* const time = time_field(layout);
  if (time == nullptr || !with_delays) return {};
  std::vector<double> times;
  layout.for_each_point([&](const char* point) { times.push_back(number_of(*time, point)); });
  // Pixels without a return have no time either, as a rule 0.
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!cloud.points[i].allFinite() || cloud.points[i].isZero()) times[i] = NAN;
  }
  const auto valid =
      std::find_if(times.begin(), times.end(), [](double t) { return !std::isnan(t); });
  if (valid == times.end()) return {};
  const double any = *valid;
  for (double& t : times) {
    if (std::isnan(t)) t = any;
  }
  return set_delays(times, *time, cloud);
}

/// livox_ros_driver/CustomMsg and livox_ros_driver2/CustomMsg.
std::string read_livox(MessageFields fields, bool with_delays, CloudMessage& cloud) {
  cloud.header = fields.header();
  fields.number<std::uint64_t>();  // time of the first point, which the header has
  fields.number<std::uint32_t>();  // number of points, as below
  for (int i = 0; i < 4; ++i) fields.number<std::uint8_t>();  // lidar_id, rsvd
  const auto count = fields.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    cloud.delays.push_back(1e-9F * static_cast<float>(fields.number<std::uint32_t>()));
    const auto x = fields.number<float>(), y = fields.number<float>(), z = fields.number<float>();
    cloud.points.emplace_back(x, y, z);
    for (int k = 0; k < 3; ++k) fields.number<std::uint8_t>();  // reflectivity, tag, line
  }
  if (!with_delays) {
    cloud.delays.clear();
  } else if (std::any_of(cloud.delays.begin(), cloud.delays.end(),
                         [](float delay) { return delay > static_cast<float>(kLongestDelay); })) {
    return "times of points lie more than 2 s from the stamp: allowed: --set input.deskew=false";
  }
  return {};
}

bool is_livox(const std::string& type) {
  return type == "livox_ros_driver/CustomMsg" || type == "livox_ros_driver2/CustomMsg";
}

}  // namespace

bool is_cloud(const std::string& type) {
  return type == kPointCloud || is_livox(type);
}

std::string read_cloud(const BagTopic& topic, std::string_view bytes, bool with_delays,
                       CloudMessage& cloud) {
  cloud.points.clear();
  cloud.delays.clear();
  const MessageFields fields(bytes, topic.encoding);
  return is_livox(topic.type) ? read_livox(fields, with_delays, cloud)
                              : read_point_cloud(fields, with_delays, cloud);
}

std::optional<double> unit_of_sweep(double length) {
  double unit = 1;
  for (int i = 0; i < 4; ++i, unit /= 1000) {
    if (length * unit <= kLongestDelay) return unit;
  }
  return {};
}

}  // namespace datasets
