#pragma once
/// Scans put together from the packets of a LiDAR (no paper section).
#include <cmath>
#include <string>
#include <vector>

#include "datasets/recording/formats/pcap/udp_datagrams.h"
#include "datasets/recording/rays/lost_azimuths.h"
#include "ldm/types.h"

namespace datasets {

struct PacketScan {
  double time = 0;                 ///< when its first packet was captured [s]
  std::vector<ldm::Point> points;  ///< as the sensor sees each where it then is [m]
  std::vector<float> delays;       ///< of the points after the first packet [s]
  LostAzimuths lost;               ///< where no packet of the turn measured
  bool clock_set = false;          ///< during the turn: delays are those of the capture
};

/// True if a sensor's clock was set since the first packet of a turn: what it and the capture say
/// of the time since then [s] differs by more than a capture delays packets.
inline bool was_set(double by_sensor, double by_capture) {
  constexpr double kLongestDelay = 0.5;
  return !(std::abs(by_sensor - by_capture) <= kLongestDelay);
}

/// What a LiDAR of one kind sends.
class PacketScans {
 public:
  virtual ~PacketScans() = default;

  /// `Velodyne VLP-16`
  virtual std::string name() const = 0;
  /// True if it may be a packet with points; only such ones are given to `take`.
  virtual bool is_packet(const Datagram& datagram) const = 0;
  /// Takes a packet, in the order in which they were captured.
  /// @return true if it is the first one of another scan: `scan` then holds the one before
  virtual bool take(const Datagram& datagram, PacketScan& scan) = 0;
  /// The last scan. @return false if there is none
  virtual bool finish(PacketScan& scan) = 0;
};

}  // namespace datasets
