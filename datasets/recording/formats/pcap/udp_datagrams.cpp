#include "datasets/recording/formats/pcap/udp_datagrams.h"

#include <algorithm>
#include <cstdio>

namespace datasets {
namespace {

constexpr std::uint16_t kIp4 = 0x0800, kIp6 = 0x86dd;
constexpr unsigned char kUdp = 17;

/// Of the network's byte order; the bytes must be there.
std::uint16_t number16(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[at]) << 8 |
                                    static_cast<unsigned char>(bytes[at + 1]));
}
unsigned char byte(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

/// The packet of IP behind the headers of its link; empty if it is none.
std::string_view ip_packet(const CapturedPacket& packet) {
  constexpr std::uint32_t kLoopback = 0, kEthernet = 1, kRaw = 101, kLinux = 113, kRawIp4 = 228,
                          kRawIp6 = 229, kLinux2 = 276;
  constexpr std::uint16_t kVlan = 0x8100, kVlanOfVlan = 0x88a8;
  std::string_view bytes = packet.bytes;
  std::size_t type_at = 0, header = 0;
  switch (packet.link) {
    case kRaw:
    case kRawIp4:
    case kRawIp6:
      return bytes;
    case kLoopback:
      return bytes.substr(std::min<std::size_t>(4, bytes.size()));
    case kEthernet:
      type_at = 12;
      header = 14;
      break;
    case kLinux:
      type_at = 14;
      header = 16;
      break;
    case kLinux2:
      header = 20;
      break;
    default:
      return {};
  }
  if (bytes.size() < header) return {};
  std::uint16_t type = number16(bytes, type_at);
  bytes.remove_prefix(header);
  while ((type == kVlan || type == kVlanOfVlan) && bytes.size() >= 4) {
    type = number16(bytes, 2);
    bytes.remove_prefix(4);
  }
  return type == kIp4 || type == kIp6 ? bytes : std::string_view();
}

std::string ip4_address(std::string_view bytes) {
  char text[16];
  std::snprintf(text, sizeof text, "%d.%d.%d.%d", byte(bytes, 0), byte(bytes, 1), byte(bytes, 2),
                byte(bytes, 3));
  return text;
}
std::string ip6_address(std::string_view bytes) {
  std::string address;
  for (std::size_t at = 0; at < 16; at += 2) {
    char group[8];
    std::snprintf(group, sizeof group, at == 0 ? "%x" : ":%x", number16(bytes, at));
    address += group;
  }
  return address;
}

/// What is behind the header of UDP; false if that is cut short.
bool take_udp(std::string_view bytes, Datagram& datagram) {
  constexpr std::size_t kHeader = 8;
  if (bytes.size() < kHeader || number16(bytes, 4) < kHeader || number16(bytes, 4) > bytes.size()) {
    return false;
  }
  datagram.port = number16(bytes, 2);
  datagram.payload = bytes.substr(kHeader, number16(bytes, 4) - kHeader);
  return true;
}

}  // namespace

bool UdpDatagrams::next(Datagram& datagram) {
  for (CapturedPacket packet; capture_.next(packet);) {
    const std::string_view bytes = ip_packet(packet);
    if (bytes.empty()) continue;
    datagram.time = packet.time;
    const int version = byte(bytes, 0) >> 4;
    if (version == 4 && take_ip4(bytes, datagram)) return true;
    if (version == 6 && take_ip6(bytes, datagram)) return true;
  }
  return false;
}

bool UdpDatagrams::take_ip4(std::string_view packet, Datagram& datagram) {
  constexpr std::size_t kLeast = 20;
  constexpr std::uint16_t kMore = 0x2000, kOffset = 0x1fff;
  if (packet.size() < kLeast) return false;
  const std::size_t header = std::size_t{4} * (byte(packet, 0) & 0xfU);
  const std::size_t size = number16(packet, 2);  // Ethernet pads what is short
  if (header < kLeast || size < header || size > packet.size() || byte(packet, 9) != kUdp) {
    return false;
  }
  std::string_view payload = packet.substr(header, size - header);
  datagram.source = ip4_address(packet.substr(12));
  const std::uint16_t flags = number16(packet, 6);
  if ((flags & (kMore | kOffset)) != 0) {
    const Key key{datagram.source, ip4_address(packet.substr(16)), number16(packet, 4)};
    if (!whole(key, std::size_t{8} * (flags & kOffset), (flags & kMore) == 0, payload))
      return false;
    payload = joined_;
  }
  return take_udp(payload, datagram);
}

/// Fragments of IPv6 are left out.
bool UdpDatagrams::take_ip6(std::string_view packet, Datagram& datagram) const {
  constexpr std::size_t kHeader = 40;
  if (packet.size() < kHeader || byte(packet, 6) != kUdp) return false;
  datagram.source = ip6_address(packet.substr(8));
  return take_udp(packet.substr(kHeader), datagram);
}

/// Adds a part. @return true if the datagram is whole: it is then in `joined_`
bool UdpDatagrams::whole(const Key& key, std::size_t offset, bool last, std::string_view part) {
  constexpr std::size_t kMostWaiting = 64;  // of what was lost on the way
  const auto [entry, is_new] = waiting_.try_emplace(key);
  if (is_new) order_.push_back(key);
  Fragments& fragments = entry->second;
  fragments.parts[offset] = part;
  if (last) fragments.size = offset + part.size();
  joined_.clear();
  for (const auto& [begin, bytes] : fragments.parts) {
    if (fragments.size > 0 && begin == joined_.size()) joined_ += bytes;
  }
  const bool complete = fragments.size > 0 && joined_.size() == fragments.size;
  if (complete || order_.size() > kMostWaiting) {
    const Key gone = complete ? key : order_.front();
    waiting_.erase(gone);
    std::erase(order_, gone);
  }
  return complete;
}

}  // namespace datasets
