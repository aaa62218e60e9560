#include "datasets/recording/formats/pcap/ouster_metadata.h"

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "datasets/files/printable.h"
#include "datasets/files/text.h"
#include "datasets/recording/scans/number_lines.h"
#include "datasets/recording/scans/trajectory.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostBeams = 256, kMostColumns = 8192, kMostOfAPacket = 128;

/// Finds what older firmware says at the top, and newer in sections.
class Metadata {
 public:
  explicit Metadata(const fs::path& file) : name_(file.string()) {
    const auto stream = open_file(file);
    const std::string text{std::istreambuf_iterator<char>(*stream), {}};
    json_ = json::parse(text, nullptr, false);
    if (!json_.is_object()) reject("no JSON object");
  }

  /// Null if it is nowhere.
  const json& find(const std::string& key) const {
    static const json null;
    for (const char* section : {"", "beam_intrinsics", "lidar_intrinsics", "lidar_data_format",
                                "data_format", "sensor_info", "config_params"}) {
      const json* in = &json_;
      if (*section != 0) {
        const auto found = json_.find(section);
        if (found == json_.end() || !found->is_object()) continue;
        in = &*found;
      }
      const auto found = in->find(key);
      if (found != in->end()) return *found;
    }
    return null;
  }
  std::optional<std::string> text(const std::string& key) const {
    const json& value = find(key);
    if (value.is_null()) return {};
    if (!value.is_string()) reject(key + " is no text");
    return printable(value.get<std::string>());
  }
  std::optional<double> number(const std::string& key) const {
    const json& value = find(key);
    if (value.is_null()) return {};
    if (!value.is_number() || !std::isfinite(value.get<double>())) reject(key + " is no number");
    return value.get<double>();
  }
  std::optional<std::size_t> count(const std::string& key, std::size_t most) const {
    const std::optional<double> value = number(key);
    if (!value) return {};
    if (!(*value >= 1 && *value <= static_cast<double>(most)) || *value != std::floor(*value)) {
      reject(key + " = " + decimal(*value) + ": allowed: 1 to " + std::to_string(most));
    }
    return static_cast<std::size_t>(*value);
  }
  /// Empty if it is nowhere.
  std::vector<double> numbers(const std::string& key) const {
    const json& value = find(key);
    std::vector<double> numbers;
    if (value.is_null()) return numbers;
    if (!value.is_array()) reject(key + " is no list of numbers");
    for (const json& element : value) {
      if (!element.is_number() || !std::isfinite(element.get<double>())) {
        reject(key + " is no list of numbers");
      }
      numbers.push_back(element.get<double>());
    }
    return numbers;
  }
  [[noreturn]] void reject(const std::string& message) const {
    throw ldm::InvalidInput(name_ + ": " + message);
  }

 private:
  std::string name_;
  json json_;
};

/// `1024x10` says the columns of a turn.
std::optional<std::size_t> columns_of(const Metadata& metadata) {
  if (const auto columns = metadata.count("columns_per_frame", kMostColumns)) return columns;
  const std::string mode = metadata.text("lidar_mode").value_or("");
  std::size_t columns = 0;
  if (!parse_number(mode.substr(0, mode.find('x')), columns) || columns == 0 ||
      columns > kMostColumns) {
    return {};
  }
  return columns;
}

Eigen::Isometry3d transform_of(const Metadata& metadata, const std::string& key) {
  constexpr std::size_t kNumbers = 16;
  constexpr double kMillimetre = 1e-3;
  const std::vector<double> numbers = metadata.numbers(key);
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  if (numbers.empty()) return transform;
  using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  if (numbers.size() != kNumbers) metadata.reject(key + " has not 16 numbers");
  const Eigen::Map<const RowMajor> matrix(numbers.data());
  const auto rotation = nearest_rotation(matrix.topLeftCorner<3, 3>());
  if (!rotation) metadata.reject(key + " holds no rotation matrix");
  transform.linear() = *rotation;
  transform.translation() = kMillimetre * matrix.topRightCorner<3, 1>();
  return transform;
}

}  // namespace

OusterMetadata read_ouster_metadata(const fs::path& file) {
  constexpr double kMillimetre = 1e-3;
  const Metadata metadata(file);
  OusterMetadata result;
  result.product = metadata.text("prod_line").value_or("of an unknown model");
  result.profile = metadata.text("udp_profile_lidar").value_or(result.profile);
  result.altitudes = metadata.numbers("beam_altitude_angles");
  result.azimuths = metadata.numbers("beam_azimuth_angles");
  result.rows = metadata.count("pixels_per_column", kMostBeams).value_or(result.altitudes.size());
  result.columns_per_packet =
      metadata.count("columns_per_packet", kMostOfAPacket).value_or(result.columns_per_packet);
  const auto columns = columns_of(metadata);
  if (!columns) metadata.reject("has no columns_per_frame and no lidar_mode such as 1024x10");
  result.columns = *columns;
  if (result.rows == 0 || result.rows > kMostBeams || result.altitudes.size() != result.rows ||
      result.azimuths.size() != result.rows) {
    metadata.reject("beam_altitude_angles and beam_azimuth_angles: allowed: one of each for " +
                    std::to_string(result.rows) + " beams, of which there are 1 to 256");
  }
  if (const auto port = metadata.count("udp_port_lidar", 65535)) {
    result.port = static_cast<std::uint16_t>(*port);
  }
  const Eigen::Isometry3d T_lidar_beam = transform_of(metadata, "beam_to_lidar_transform");
  const bool has_beam = !metadata.find("beam_to_lidar_transform").is_null();
  result.beam_x = has_beam
                      ? T_lidar_beam.translation().x()
                      : kMillimetre * metadata.number("lidar_origin_to_beam_origin_mm").value_or(0);
  result.beam_z = T_lidar_beam.translation().z();
  result.T_sensor_lidar = transform_of(metadata, "lidar_to_sensor_transform");
  return result;
}

bool is_ouster_metadata(const fs::path& file) {
  try {
    return Metadata(file).find("beam_altitude_angles").is_array();
  } catch (const ldm::InvalidInput&) {
    return false;
  }
}

}  // namespace datasets
