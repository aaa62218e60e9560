#pragma once
/// The UDP datagrams of a capture file (no paper section).
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <tuple>

#include "datasets/recording/formats/pcap/capture_file.h"

namespace datasets {

struct Datagram {
  double time = 0;           ///< when its last part was captured [s]
  std::string source;        ///< address, for instance `192.168.1.201`
  std::uint16_t port = 0;    ///< where it went
  std::string_view payload;  ///< until the next one is read
};

/// Reads what went by UDP over IPv4 or IPv6, on Ethernet, a loopback, or as Linux captures any of
/// these, with VLAN tags or without. Datagrams that IPv4 sent in fragments, as Ouster's are, are
/// put together again. Anything else is left out.
class UdpDatagrams {
 public:
  /// @throws ldm::InvalidInput if the file cannot be read or is none.
  explicit UdpDatagrams(const std::filesystem::path& file) : capture_(file) {}

  /// False at the end.
  /// @throws BrokenFrame where the file is damaged: it then ends.
  bool next(Datagram& datagram);
  const std::string& place() const { return capture_.place(); }

 private:
  /// Source, destination and number of a datagram whose fragments come one after the other.
  using Key = std::tuple<std::string, std::string, std::uint16_t>;
  struct Fragments {
    std::map<std::size_t, std::string> parts;  // by offset
    std::size_t size = 0;                      // of all; 0: the last one is missing
  };

  bool take_ip4(std::string_view packet, Datagram& datagram);
  bool take_ip6(std::string_view packet, Datagram& datagram) const;
  bool whole(const Key& key, std::size_t offset, bool last, std::string_view part);

  CaptureFile capture_;
  std::map<Key, Fragments> waiting_;
  std::deque<Key> order_;  // of those, the oldest first
  std::string joined_;
};

}  // namespace datasets
