#pragma once
/// What is in a capture file, and what of it is taken (no paper section).
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "datasets/recording/formats/pcap/packet_scans.h"

namespace datasets {

/// Datagrams of one size that went one way.
struct PcapStream {
  std::string source;
  std::uint16_t port = 0;
  std::size_t size = 0;  ///< [bytes]
  std::int64_t datagrams = 0;
  double first = 0, last = 0;  ///< captured [s]

  bool has(const Datagram& datagram) const {
    return datagram.source == source && datagram.port == port && datagram.payload.size() == size;
  }
  /// `192.168.1.201 to port 2368: 1206 bytes`
  std::string text() const;
};

/// All streams, in the order in which they begin; damage ends the file.
/// @throws ldm::InvalidInput if the file cannot be read or is none.
std::vector<PcapStream> read_streams(const std::filesystem::path& file);

/// What gives a file's scans.
struct PcapPlan {
  std::unique_ptr<PacketScans> scans;
  std::string source;  ///< the first sensor whose packets they are: its address
  std::uint16_t port = 0;
};

/// By the first packet of a Velodyne sensor or, if there is a metadata file, of the Ouster sensor
/// that it describes: NAME.json beside NAME.pcap, else the only one in the folder.
/// @throws ldm::InvalidInput if there is neither, or the file cannot be read.
PcapPlan plan_of_pcap(const std::filesystem::path& file);

}  // namespace datasets
