#include "datasets/recording/formats/pcap/velodyne_scans.h"

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>

namespace datasets {
namespace {

using mrpt::obs::CObservationVelodyneScan;
using Packet = CObservationVelodyneScan::TVelodyneRawPacket;

struct Model {
  unsigned char number;
  std::string_view name;
  const char* calibration;  // MRPT's
};
constexpr std::array kModels = {Model{0x21, "Velodyne HDL-32E", "HDL32"},
                                Model{0x22, "Velodyne VLP-16", "VLP16"}};

Packet packet_in(const Datagram& datagram) {
  Packet packet;
  std::memcpy(&packet, datagram.payload.data(), sizeof packet);
  return packet;
}

/// True if each block is of the lasers that all models have, at an angle of a turn.
bool is_whole(const Packet& packet) {
  return std::all_of(std::begin(packet.blocks), std::end(packet.blocks), [](const auto& block) {
    return block.header() == CObservationVelodyneScan::UPPER_BANK &&
           block.rotation() < CObservationVelodyneScan::ROTATION_MAX_UNITS;
  });
}

/// True if a block is of the lower half of the 64 lasers.
bool is_of_64(const Packet& packet) {
  return std::any_of(std::begin(packet.blocks), std::end(packet.blocks), [](const auto& block) {
    return block.header() == CObservationVelodyneScan::LOWER_BANK;
  });
}

class VelodyneScans : public PacketScans {
 public:
  explicit VelodyneScans(const Model& model) : model_(model) {
    observation_.calibration =
        mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model.calibration);
    // Ranges of 0 are no returns; of others the filter knows better.
    observation_.minRange = CObservationVelodyneScan::DISTANCE_RESOLUTION / 2;
    observation_.maxRange = 1000;
    parameters_.minDistance = 0;
    parameters_.generatePerPointAzimuth = true;
  }

  std::string name() const override { return std::string(model_.name); }
  bool is_packet(const Datagram& datagram) const override {
    if (!is_velodyne(datagram)) return false;
    const Packet packet = packet_in(datagram);
    return packet.velodyne_model_ID == model_.number && is_whole(packet);
  }
  /// A scan ends where the azimuth begins anew.
  bool take(const Datagram& datagram, PacketScan& scan) override {
    const Packet packet = packet_in(datagram);
    const bool ends = !packets_.empty() &&
                      packet.blocks[0].rotation() < packets_.back().blocks[0].rotation() &&
                      finish(scan);
    if (packets_.empty()) time_ = datagram.time;
    packets_.push_back(packet);
    return ends;
  }
  bool finish(PacketScan& scan) override {
    if (packets_.empty()) return false;
    scan.time = time_;
    scan.points.clear();
    scan.delays.clear();
    for (std::size_t k = 0; k < packets_.size(); ++k) take_points(k, scan);
    packets_.clear();
    return true;
  }

 private:
  void take_points(std::size_t k, PacketScan& scan) {
    observation_.scan_packets.assign(1, packets_[k]);
    observation_.generatePointCloud(parameters_);
    const auto& cloud = observation_.point_cloud;
    const double begin = seconds_between(packets_[0], packets_[k]), azimuth = degrees(packets_[k]);
    const double per_degree = seconds_per_degree(k);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      // MRPT's own times are those of whole packets.
      const double turn = std::remainder(static_cast<double>(cloud.azimuth[i]) - azimuth, kTurn);
      scan.points.emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
      scan.delays.push_back(static_cast<float>(begin + turn * per_degree));
    }
  }

  /// How fast the sensor turns, from a packet to the next, or for the last from the one before; 0
  /// if nothing tells.
  double seconds_per_degree(std::size_t k) const {
    if (packets_.size() < 2) return 0;
    const std::size_t first = std::min(k, packets_.size() - 2);
    const Packet &a = packets_[first], &b = packets_[first + 1];
    const double turn = degrees(b) - degrees(a);
    return turn > 0 ? seconds_between(a, b) / turn : 0;
  }

  static double degrees(const Packet& packet) {
    return static_cast<double>(CObservationVelodyneScan::ROTATION_RESOLUTION) *
           packet.blocks[0].rotation();
  }
  /// By the sensor's clock, which counts the time of the hour; it may be set back a little.
  static double seconds_between(const Packet& a, const Packet& b) {
    constexpr double kHour = 3600;
    const double seconds =
        1e-6 * (static_cast<double>(b.gps_timestamp()) - static_cast<double>(a.gps_timestamp()));
    return seconds < -kHour / 2 ? seconds + kHour : seconds;
  }

  static constexpr double kTurn = 360;  // [deg]

  const Model& model_;
  CObservationVelodyneScan observation_;
  CObservationVelodyneScan::TGeneratePointCloudParameters parameters_;
  std::vector<Packet> packets_;  // of the scan
  double time_ = 0;              // of the first of them
};

}  // namespace

bool is_velodyne(const Datagram& datagram) {
  return datagram.payload.size() == CObservationVelodyneScan::PACKET_SIZE &&
         (datagram.payload.starts_with("\xff\xee") || datagram.payload.starts_with("\xff\xdd"));
}

std::unique_ptr<PacketScans> velodyne_scans(const Datagram& first, const std::string& place) {
  const Packet packet = packet_in(first);
  for (const Model& model : kModels) {
    if (packet.velodyne_model_ID == model.number && !is_of_64(packet))
      return std::make_unique<VelodyneScans>(model);
  }
  char number[8];
  std::snprintf(number, sizeof number, "0x%02x", packet.velodyne_model_ID);
  throw ldm::InvalidInput(place + ": a Velodyne sensor of model " +
                          (is_of_64(packet) ? "HDL-64E" : number) +
                          ": allowed: 0x21 (HDL-32E) and 0x22 (VLP-16)");
}

}  // namespace datasets
