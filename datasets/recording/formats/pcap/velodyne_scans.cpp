#include "datasets/recording/formats/pcap/velodyne_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <numbers>

#include "datasets/recording/formats/velodyne_packet.h"

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
    calibration_ = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model.calibration);
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
    if (packets_.empty()) captured_.clear();
    packets_.push_back(packet);
    captured_.push_back(datagram.time);
    return ends;
  }
  bool finish(PacketScan& scan) override {
    if (packets_.empty()) return false;
    scan.time = captured_[0];
    scan.points.clear();
    scan.delays.clear();
    find_lost(scan.lost);
    clock_set_ = scan.clock_set = clock_was_set();
    for (std::size_t k = 0; k < packets_.size(); ++k) take_points(k, scan);
    packets_.clear();
    return true;
  }

 private:
  void take_points(std::size_t k, PacketScan& scan) {
    points_.clear();
    take_velodyne_points(packets_[k], calibration_, points_);
    const double begin = seconds_between(0, k), azimuth = degrees(packets_[k]);
    const double per_degree = seconds_per_degree(k);
    for (const VelodynePoint& p : points_) {
      const double turn = std::remainder(p.azimuth - azimuth, kTurn);
      scan.points.push_back(p.point);
      scan.delays.push_back(static_cast<float>(begin + turn * per_degree));
    }
  }

  /// How fast the sensor turns, from a packet to the next, or for the last from the one before; 0
  /// if nothing tells.
  double seconds_per_degree(std::size_t k) const {
    if (packets_.size() < 2) return 0;
    const std::size_t first = std::min(k, packets_.size() - 2);
    const double turn = degrees(packets_[first + 1]) - degrees(packets_[first]);
    return turn > 0 ? seconds_between(first, first + 1) / turn : 0;
  }

  /// Between two packets of the scan.
  double seconds_between(std::size_t a, std::size_t b) const {
    return clock_set_ ? captured_[b] - captured_[a] : by_sensor(packets_[a], packets_[b]);
  }

  bool clock_was_set() const {
    for (std::size_t k = 1; k < packets_.size(); ++k) {
      if (by_sensor(packets_[k - 1], packets_[k]) < 0 ||
          was_set(by_sensor(packets_[0], packets_[k]), captured_[k] - captured_[0])) {
        return true;
      }
    }
    return false;
  }

  /// Between blocks that are farther apart than most packets were lost, and between the last one
  /// and the first a part of the turn is missing.
  void find_lost(LostAzimuths& lost) const {
    lost.clear();
    std::vector<double> azimuths;  // from the first block on, of one turn [deg]
    for (const Packet& packet : packets_) {
      for (const auto& block : packet.blocks) {
        const double azimuth = degrees(block);
        if (azimuths.empty()) {
          azimuths.push_back(azimuth);
        } else if (const double step = std::remainder(azimuth - azimuths.back(), kTurn); step > 0) {
          azimuths.push_back(azimuths.back() + step);
        } else if (step < 0) {
          azimuths.push_back(azimuths.back() + step + kTurn);
        }
      }
    }
    std::vector<double> steps;
    for (std::size_t i = 1; i < azimuths.size(); ++i) {
      steps.push_back(azimuths[i] - azimuths[i - 1]);
    }
    if (steps.empty()) return lost.add(0, kDegree * kTurn);
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    const double step = *middle, longest = 1.5 * step;
    // Velodyne's azimuths grow clockwise. Each block is of the step behind its azimuth.
    const auto lose = [&](double from, double to) {
      if (to - from > longest) lost.add(-kDegree * to, kDegree * (to - from - step));
    };
    for (std::size_t i = 1; i < azimuths.size(); ++i) lose(azimuths[i - 1], azimuths[i]);
    lose(azimuths.back(), azimuths.front() + kTurn);
  }

  /// MRPT's own way to it is by a reference, for which packets one behind the other are not
  /// aligned.
  static double microseconds(const Packet& packet) {
    std::uint32_t count = 0;
    std::memcpy(&count, reinterpret_cast<const char*>(&packet) + sizeof packet - 6, sizeof count);
    return static_cast<double>(count);
  }
  template <class Block>
  static double degrees(const Block& block) {
    return static_cast<double>(CObservationVelodyneScan::ROTATION_RESOLUTION) * block.rotation();
  }
  static double degrees(const Packet& packet) { return degrees(packet.blocks[0]); }
  /// Seconds between two packets by the sensor's clock, which counts the time of the hour.
  static double by_sensor(const Packet& a, const Packet& b) {
    constexpr double kHour = 3600;
    const double seconds = 1e-6 * (microseconds(b) - microseconds(a));
    return seconds < -kHour / 2 ? seconds + kHour : seconds;
  }

  static constexpr double kTurn = 360;                               // [deg]
  static constexpr double kDegree = std::numbers::pi / (kTurn / 2);  // [rad]

  const Model& model_;
  mrpt::obs::VelodyneCalibration calibration_;
  std::vector<VelodynePoint> points_;
  std::vector<Packet> packets_;   // of the scan
  std::vector<double> captured_;  // when each of them was [s]
  bool clock_set_ = false;        // between two of them
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
