#pragma once
/// Writes capture files, and packets of Velodyne's and Ouster's sensors, by their manuals.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace datasets {

/// The bytes of a number, little-endian or as networks have it.
template <class Number>
std::string little(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}
template <class Number>
std::string big(Number number) {
  const std::string bytes = little(number);
  return {bytes.rbegin(), bytes.rend()};
}

struct TestPacket {
  double time = 0;    // [s]
  std::string bytes;  // from the header of Ethernet on
};

inline std::string ethernet(const std::string& ip_packet, bool vlan = false) {
  const std::string type = static_cast<unsigned char>(ip_packet[0]) >> 4 == 4
                               ? std::string("\x08\x00", 2)
                               : std::string("\x86\xdd", 2);
  return std::string(12, 'e') + (vlan ? std::string("\x81\x00\x00\x07", 4) : "") + type + ip_packet;
}

inline std::string udp(std::uint16_t port, const std::string& payload) {
  return big<std::uint16_t>(40000) + big(port) +
         big(static_cast<std::uint16_t>(8 + payload.size())) + big<std::uint16_t>(0) + payload;
}

/// IPv4 from 192.168.1.HOST, in fragments of at most `most` bytes.
inline std::vector<std::string> ip4(int host, const std::string& datagram, std::uint16_t number = 1,
                                    std::size_t most = 1480) {
  std::vector<std::string> packets;
  for (std::size_t at = 0; at < datagram.size(); at += most) {
    const std::string part = datagram.substr(at, most);
    const bool more = at + part.size() < datagram.size();
    packets.push_back(std::string("\x45\x00", 2) +
                      big(static_cast<std::uint16_t>(20 + part.size())) + big(number) +
                      big(static_cast<std::uint16_t>((more ? 0x2000 : 0) | at / 8)) +
                      std::string("\x40\x11\x00\x00", 4) + std::string("\xc0\xa8\x01", 3) +
                      static_cast<char>(host) + std::string("\xff\xff\xff\xff", 4) + part);
  }
  return packets;
}

/// A datagram on Ethernet as a sensor sends it.
inline std::vector<TestPacket> sent(double time, int host, std::uint16_t port,
                                    const std::string& payload, std::uint16_t number = 1) {
  std::vector<TestPacket> packets;
  for (const std::string& packet : ip4(host, udp(port, payload), number)) {
    packets.push_back({time, ethernet(packet)});
  }
  return packets;
}

struct PcapForm {
  bool swapped = false;  // the other byte order
  bool nanoseconds = false;
  std::uint32_t link = 1;  // Ethernet
};

template <class Number>
std::string ordered(Number number, bool swapped) {
  return swapped ? big(number) : little(number);
}

inline std::string pcap_file(const std::vector<TestPacket>& packets, const PcapForm& form = {}) {
  const auto number = [&](auto value) { return ordered(value, form.swapped); };
  std::string file = number(std::uint32_t{form.nanoseconds ? 0xa1b23c4dU : 0xa1b2c3d4U}) +
                     number(std::uint16_t{2}) + number(std::uint16_t{4}) + std::string(8, '\0') +
                     number(std::uint32_t{65535}) + number(form.link);
  for (const TestPacket& packet : packets) {
    const double seconds = std::floor(packet.time);
    const double ticks = std::round((packet.time - seconds) * (form.nanoseconds ? 1e9 : 1e6));
    const auto size = static_cast<std::uint32_t>(packet.bytes.size());
    file += number(static_cast<std::uint32_t>(seconds)) +
            number(static_cast<std::uint32_t>(ticks)) + number(size) + number(size) + packet.bytes;
  }
  return file;
}

/// pcapng with a network whose times count 1 / 2^20 s, and a block of another kind.
inline std::string pcapng_file(const std::vector<TestPacket>& packets, bool swapped = false) {
  const auto number = [&](auto value) { return ordered(value, swapped); };
  const auto block = [&](std::uint32_t type, std::string body) {
    body.resize((body.size() + 3) / 4 * 4);
    const auto size = static_cast<std::uint32_t>(12 + body.size());
    return number(type) + number(size) + body + number(size);
  };
  std::string file =
      block(0x0a0d0d0a, number(std::uint32_t{0x1a2b3c4d}) + number(std::uint16_t{1}) +
                            number(std::uint16_t{0}) + std::string(8, '\xff'));
  file += block(1, number(std::uint16_t{1}) + number(std::uint16_t{0}) + number(std::uint32_t{0}) +
                       number(std::uint16_t{2}) + number(std::uint16_t{5}) + "lidar" +
                       std::string(3, '\0') + number(std::uint16_t{9}) + number(std::uint16_t{1}) +
                       std::string("\x94\0\0\0", 4) + std::string(4, '\0'));
  for (const TestPacket& packet : packets) {
    const auto ticks = static_cast<std::uint64_t>(std::round(packet.time * (1 << 20)));
    const auto size = static_cast<std::uint32_t>(packet.bytes.size());
    file += block(6, number(std::uint32_t{0}) + number(static_cast<std::uint32_t>(ticks >> 32)) +
                         number(static_cast<std::uint32_t>(ticks)) + number(size) + number(size) +
                         packet.bytes);
    file += block(5, std::string(8, '\0'));
  }
  return file;
}

/// A packet of a VLP-16: twelve blocks from azimuth `degrees` on, 0.4 degrees apart, in each of
/// which laser 0, 15 degrees down, sees something `range` metres away in the first of two firings.
inline std::string velodyne_packet(double degrees, double range, std::uint32_t microseconds,
                                   unsigned char model = 0x22) {
  std::string packet;
  for (int block = 0; block < 12; ++block) {
    const double azimuth = std::fmod(degrees + 0.4 * block, 360);
    packet += std::string("\xff\xee", 2) +
              little(static_cast<std::uint16_t>(std::lround(100 * azimuth) % 36000)) +
              little(static_cast<std::uint16_t>(std::lround(range / 0.002))) + 'i' +
              std::string(93, '\0');
  }
  return packet + little(microseconds) + '\x37' + static_cast<char>(model);
}

/// The same, but all lasers see something range_of(azimuth) [m] away, 0 for nothing, in both
/// firings of each block; the second is 0.2 degrees on.
template <class RangeOf>
std::string velodyne_sweep(double degrees, RangeOf&& range_of, std::uint32_t microseconds,
                           unsigned char model = 0x22) {
  std::string packet;
  for (int block = 0; block < 12; ++block) {
    const double azimuth = std::fmod(degrees + 0.4 * block, 360);
    packet += std::string("\xff\xee", 2) +
              little(static_cast<std::uint16_t>(std::lround(100 * azimuth) % 36000));
    for (int laser = 0; laser < 32; ++laser) {
      const double range = range_of(std::fmod(azimuth + (laser < 16 ? 0 : 0.2), 360));
      packet += little(static_cast<std::uint16_t>(std::lround(range / 0.002))) + 'i';
    }
  }
  return packet + little(microseconds) + '\x37' + static_cast<char>(model);
}

/// How one of Ouster's profiles lays out a packet.
struct OusterForm {
  std::string profile;
  std::size_t pixel_bytes;
  bool low_data;  // ranges of 15 bits and 8 mm
  bool dual;
};
inline const std::vector<OusterForm>& ouster_forms() {
  static const std::vector<OusterForm> forms = {{"LEGACY", 12, false, false},
                                                {"RNG19_RFL8_SIG16_NIR16", 12, false, false},
                                                {"RNG19_RFL8_SIG16_NIR16_DUAL", 16, false, true},
                                                {"RNG15_RFL8_NIR8", 4, true, false},
                                                {"FUSA_RNG15_RFL8_NIR8_DUAL", 8, true, true}};
  return forms;
}

/// One column of a sensor of two beams.
struct OusterColumn {
  std::uint64_t time = 0;  // [ns]
  std::uint16_t number = 0;
  std::uint32_t first = 0,
                second = 0;  // range in each row; of dual ones the second return, too [mm]
  bool measured = true;
};

inline std::string ouster_pixel(const OusterForm& form, std::uint32_t range) {
  // All other bits are set, to see that nobody takes them for a range.
  const auto low = static_cast<std::uint16_t>(range / 8 | 0x8000U);
  std::string pixel = form.low_data ? little(low) + "\xff\xff" : little(range | 0xfff80000U);
  if (form.profile == "LEGACY") pixel = little(range | 0xfff00000U);
  if (form.dual) pixel += pixel;
  pixel.resize(form.pixel_bytes, '\xff');
  return pixel;
}

inline std::string ouster_packet(const OusterForm& form, std::uint16_t frame,
                                 const std::vector<OusterColumn>& columns, char type = 1) {
  const bool legacy = form.profile == "LEGACY", fusa = form.profile.starts_with("FUSA");
  std::string packet;
  if (fusa) packet = type + std::string(3, 'i') + little(std::uint32_t{frame});
  if (!legacy && !fusa) packet = type + std::string(1, '\0') + little(frame);
  if (!legacy) packet.resize(32, 'h');
  for (const OusterColumn& column : columns) {
    packet += little(column.time) + little(column.number);
    packet += legacy ? little(frame) + std::string(4, 'e')
                     : little(static_cast<std::uint16_t>(column.measured ? 0xff01 : 0xff00));
    packet += ouster_pixel(form, column.first) + ouster_pixel(form, column.second);
    if (legacy) packet += little(std::uint32_t{column.measured ? 0xffffffffU : 0U});
  }
  return packet + (legacy ? "" : std::string(32, 'f'));
}

/// Metadata of a sensor of two beams, 30 degrees up and down, the first 10 degrees to the left of
/// the second; 8 columns a turn, 4 a packet. The beams begin 20 mm from the axis of the turn, which
/// is 36 mm above the sensor's base and looks backwards.
inline std::string ouster_metadata(const std::string& profile, bool sections = true) {
  const std::string beams =
      R"("beam_altitude_angles": [30, -30], "beam_azimuth_angles": [-10, 0], )"
      R"("lidar_origin_to_beam_origin_mm": 20)";
  const std::string transform =
      R"("lidar_to_sensor_transform": [-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 36, 0, 0, 0, 1])";
  const std::string format =
      R"("pixels_per_column": 2, "columns_per_frame": 8, "columns_per_packet": 4, )"
      R"("udp_profile_lidar": ")" +
      profile + "\"";
  if (!sections) {
    return "{" + beams + ", " + transform + R"(, "prod_line": "OS-T", "udp_port_lidar": 7502, )" +
           R"("lidar_mode": "8x10", "data_format": {)" + format + "}}";
  }
  return R"({"beam_intrinsics": {)" + beams + R"(, "beam_to_lidar_transform": )" +
         "[1, 0, 0, 20, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}, " + R"("lidar_intrinsics": {)" +
         transform + R"(}, "lidar_data_format": {)" + format +
         R"(}, "sensor_info": {"prod_line": "OS-T"}, "config_params": {"udp_port_lidar": 7502}})";
}

}  // namespace datasets
