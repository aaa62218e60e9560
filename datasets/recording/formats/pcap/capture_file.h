#pragma once
/// What a program as tcpdump or Wireshark recorded of a network (no paper section).
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/recording/formats/record_file.h"

namespace datasets {

struct CapturedPacket {
  double time = 0;  ///< when it was captured [s]
  std::uint32_t link =
      0;  ///< LINKTYPE_ of its first header, https://www.tcpdump.org/linktypes.html
  std::string_view bytes;  ///< until the next one is read
};

/// Reads a capture file packet by packet: pcap of either byte order, with us or ns, and pcapng.
class CaptureFile {
 public:
  /// @throws ldm::InvalidInput if it cannot be read or is none.
  explicit CaptureFile(const std::filesystem::path& file);

  /// False at the end.
  /// @throws BrokenFrame where the file is damaged: it then ends.
  bool next(CapturedPacket& packet);
  /// `file: byte 1234`, where the last packet begins
  const std::string& place() const { return place_; }

 private:
  /// Of a network that pcapng recorded.
  struct Interface {
    std::uint32_t link = 0;
    double tick = 1e-6;  // [s]
  };

  std::uint32_t number32();
  std::uint16_t number16(std::string_view bytes, std::size_t at) const;
  std::uint32_t number32(std::string_view bytes, std::size_t at) const;
  bool next_of_pcap(CapturedPacket& packet);
  bool next_of_pcapng(CapturedPacket& packet);
  void begin_section();
  void add_interface(std::string_view body);
  bool take_packet(std::string_view body, CapturedPacket& packet) const;

  RecordFile file_;
  bool swapped_ = false;  // numbers are of the other byte order
  bool next_generation_ = false;
  std::vector<Interface> interfaces_;  // of pcap, one
  std::string buffer_, place_;
};

}  // namespace datasets
