#include "datasets/recording/formats/pcap/ouster_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "datasets/recording/formats/pcap/ouster_metadata.h"

namespace datasets {
namespace {

/// How a profile lays out its pixels.
struct Profile {
  std::string_view name;
  std::size_t pixel_bytes;
  std::size_t returns;      // ranges of a pixel, one behind the other
  std::size_t range_bytes;  // from one to the next
  int range_bits;
  double unit;           // of a range [m]
  std::size_t frame_at;  // where the packet says which turn it is of
  std::size_t frame_bytes;
  std::size_t packet_header;  // and footer, of equal size [bytes]
  std::size_t column_header, column_footer;
};
// The footer of a column says, in LEGACY, whether it was measured; the headers of others do.
constexpr std::array kProfiles = {
    Profile{"LEGACY", 12, 1, 0, 20, 1e-3, 10, 2, 0, 16, 4},
    Profile{"RNG19_RFL8_SIG16_NIR16", 12, 1, 0, 19, 1e-3, 2, 2, 32, 12, 0},
    Profile{"RNG19_RFL8_SIG16_NIR16_DUAL", 16, 2, 4, 19, 1e-3, 2, 2, 32, 12, 0},
    Profile{"RNG15_RFL8_NIR8", 4, 1, 0, 15, 8e-3, 2, 2, 32, 12, 0},
    Profile{"FUSA_RNG15_RFL8_NIR8_DUAL", 8, 2, 4, 15, 8e-3, 4, 4, 32, 12, 0}};

const Profile& profile_of(const OusterMetadata& metadata, const std::string& file) {
  std::string known;
  for (const Profile& profile : kProfiles) {
    if (profile.name == metadata.profile) return profile;
    known.append(known.empty() ? "" : ", ").append(profile.name);
  }
  throw ldm::InvalidInput(file + ": packets of profile " + metadata.profile +
                          ": allowed: " + known);
}

/// A little-endian number of up to 8 bytes.
std::uint64_t number_at(const char* bytes, std::size_t size) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes, size);
  return number;
}

class OusterScans : public PacketScans {
 public:
  explicit OusterScans(const std::filesystem::path& file)
      : metadata_(read_ouster_metadata(file)),
        profile_(profile_of(metadata_, file.string())),
        column_bytes_(profile_.column_header + metadata_.rows * profile_.pixel_bytes +
                      profile_.column_footer),
        packet_bytes_(2 * profile_.packet_header + metadata_.columns_per_packet * column_bytes_) {
    for (std::size_t row = 0; row < metadata_.rows; ++row) {
      const double altitude = kDegree * metadata_.altitudes[row];
      const double azimuth = -kDegree * metadata_.azimuths[row];
      rays_.emplace_back(std::cos(altitude) * std::cos(azimuth),
                         std::cos(altitude) * std::sin(azimuth), std::sin(altitude));
      least_azimuth_ = std::min(least_azimuth_, azimuth);
      largest_azimuth_ = std::max(largest_azimuth_, azimuth);
    }
  }

  std::string name() const override { return "Ouster " + metadata_.product; }
  bool is_packet(const Datagram& datagram) const override {
    constexpr std::uint64_t kLidar = 1;  // other types: IMU, zones
    if (datagram.payload.size() != packet_bytes_) return false;
    if (metadata_.port && datagram.port != *metadata_.port) return false;
    return profile_.packet_header == 0 ||
           number_at(datagram.payload.data(), profile_.frame_at == 2 ? 2 : 1) == kLidar;
  }
  bool take(const Datagram& datagram, PacketScan& scan) override {
    const char* const bytes = datagram.payload.data();
    const std::uint64_t frame = number_at(bytes + profile_.frame_at, profile_.frame_bytes);
    // What comes late is of a scan that is done.
    if (last_ && frame == *last_) return false;
    const bool ends = frame_ && frame != *frame_;
    if (ends) {
      last_ = frame_;
      end(scan);
    }
    if (ends || !frame_) begin(frame, datagram);
    captured_ = datagram.time - scan_.time;
    for (std::size_t k = 0; k < metadata_.columns_per_packet; ++k) {
      take_column(bytes + profile_.packet_header + k * column_bytes_);
    }
    return ends;
  }
  bool finish(PacketScan& scan) override {
    if (!frame_) return false;
    frame_.reset();
    end(scan);
    return true;
  }

 private:
  static constexpr double kTurn = 2 * std::numbers::pi, kDegree = kTurn / 360;  // [rad]

  void begin(std::uint64_t frame, const Datagram& datagram) {
    frame_ = frame;
    scan_.time = datagram.time;
    scan_.points.clear();
    scan_.delays.clear();
    scan_.clock_set = false;
    delays_captured_.clear();
    measured_.assign(metadata_.columns, 0);
    first_.reset();
  }

  void end(PacketScan& scan) {
    if (scan_.clock_set) scan_.delays = delays_captured_;
    find_lost();
    std::swap(scan, scan_);
  }

  /// Where beams of columns that were not measured, or came with no packet, may have looked.
  void find_lost() {
    scan_.lost.clear();
    const Eigen::Vector3d ahead = metadata_.T_sensor_lidar.linear().col(0);
    const double lidar = std::atan2(ahead.y(), ahead.x());
    const double step = kTurn / static_cast<double>(metadata_.columns);
    for (std::size_t column = 0; column < measured_.size(); ++column) {
      if (measured_[column] != 0) continue;
      const double azimuth = lidar - step * static_cast<double>(column);
      scan_.lost.add(azimuth - step / 2 + least_azimuth_, step + largest_azimuth_ - least_azimuth_);
    }
  }

  void take_column(const char* column) {
    constexpr std::uint64_t kMeasured = 0xffffffff;
    const bool measured = profile_.column_footer > 0
                              ? number_at(column + column_bytes_ - 4, 4) == kMeasured
                              : (number_at(column + 10, 2) & 1U) != 0;
    const std::uint64_t number = number_at(column + 8, 2);
    if (!measured || number >= metadata_.columns) return;
    measured_[number] = 1;
    const std::uint64_t time = number_at(column, sizeof time);
    // The first packets of a turn may hold nothing that was measured.
    if (!first_) {
      first_ = time;
      first_captured_ = captured_;
    }
    const double by_sensor =
        first_captured_ + 1e-9 * static_cast<double>(static_cast<std::int64_t>(time - *first_));
    scan_.clock_set = scan_.clock_set || was_set(by_sensor, captured_);
    const auto delay = static_cast<float>(by_sensor);
    const double turn =
        kTurn * (1 - static_cast<double>(number) / static_cast<double>(metadata_.columns));
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Isometry3d& to_sensor = metadata_.T_sensor_lidar;
    const Eigen::Vector3d begin =
        to_sensor * (rotation * Eigen::Vector3d(metadata_.beam_x, 0, metadata_.beam_z));
    const Eigen::Matrix3d turned = to_sensor.linear() * rotation;
    const double before = std::hypot(metadata_.beam_x, metadata_.beam_z);
    const std::uint64_t mask = (std::uint64_t{1} << profile_.range_bits) - 1;
    for (std::size_t row = 0; row < metadata_.rows; ++row) {
      const char* const pixel = column + profile_.column_header + row * profile_.pixel_bytes;
      for (std::size_t k = 0; k < profile_.returns; ++k) {
        // The range of two bytes stands before a byte of another field, as that of four does.
        const std::uint64_t bits = number_at(pixel + k * profile_.range_bytes, 4) & mask;
        if (bits == 0) continue;
        const double range = profile_.unit * static_cast<double>(bits) - before;
        scan_.points.push_back((begin + range * (turned * rays_[row])).cast<float>());
        scan_.delays.push_back(delay);
        delays_captured_.push_back(static_cast<float>(captured_));
      }
    }
  }

  OusterMetadata metadata_;
  const Profile& profile_;
  std::size_t column_bytes_, packet_bytes_;
  std::vector<Eigen::Vector3d> rays_;               // of the rows, in the frame of a column
  double least_azimuth_ = 0, largest_azimuth_ = 0;  // of these [rad]
  std::optional<std::uint64_t> frame_, last_;       // number of this scan, and of the one before
  std::optional<std::uint64_t> first_;              // time of its first measured column [ns]
  double captured_ = 0,
         first_captured_ = 0;           // packets of this and that column, after the first [s]
  std::vector<float> delays_captured_;  // of the points, by the packets [s]
  std::vector<std::uint8_t> measured_;  // columns of this scan
  PacketScan scan_;
};

}  // namespace

std::unique_ptr<PacketScans> ouster_scans(const std::filesystem::path& metadata) {
  return std::make_unique<OusterScans>(metadata);
}

}  // namespace datasets
