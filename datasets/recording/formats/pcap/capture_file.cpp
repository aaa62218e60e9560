#include "datasets/recording/formats/pcap/capture_file.h"

#include <cmath>
#include <cstring>

#include "ldm/types.h"

namespace datasets {
namespace {

constexpr std::uint32_t kMicroseconds = 0xa1b2c3d4, kNanoseconds = 0xa1b23c4d;
constexpr std::uint32_t kSection = 0x0a0d0d0a, kByteOrder = 0x1a2b3c4d;
constexpr std::uint32_t kInterface = 1, kSimplePacket = 3, kPacket = 6;
constexpr std::uint32_t kLargest = std::uint32_t{1} << 24;  // [bytes] of a packet or block

std::uint32_t swapped32(std::uint32_t number) {
  return __builtin_bswap32(number);
}

}  // namespace

CaptureFile::CaptureFile(const std::filesystem::path& file) : file_(file) {
  constexpr std::uint64_t kRestOfHeader = 16;
  const std::uint32_t magic = file_.size() < 24 ? 0 : file_.number<std::uint32_t>();
  next_generation_ = magic == kSection;
  if (next_generation_) {
    begin_section();
    return;
  }
  for (const bool swapped : {false, true}) {
    const std::uint32_t number = swapped ? swapped32(magic) : magic;
    if (number != kMicroseconds && number != kNanoseconds) continue;
    swapped_ = swapped;
    file_.skip(kRestOfHeader);
    // The upper bits say whether the packets end with a check sum.
    interfaces_.push_back({number32() & 0xffff, number == kNanoseconds ? 1e-9 : 1e-6});
    return;
  }
  throw ldm::InvalidInput(file.string() + ": no capture file: allowed: pcap or pcapng");
}

bool CaptureFile::next(CapturedPacket& packet) {
  return next_generation_ ? next_of_pcapng(packet) : next_of_pcap(packet);
}

std::uint32_t CaptureFile::number32() {
  const auto number = file_.number<std::uint32_t>();
  return swapped_ ? swapped32(number) : number;
}
std::uint32_t CaptureFile::number32(std::string_view bytes, std::size_t at) const {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return swapped_ ? swapped32(number) : number;
}
std::uint16_t CaptureFile::number16(std::string_view bytes, std::size_t at) const {
  std::uint16_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return swapped_ ? __builtin_bswap16(number) : number;
}

bool CaptureFile::next_of_pcap(CapturedPacket& packet) {
  if (file_.at_end()) return false;
  place_ = file_.place();
  const std::uint32_t seconds = number32(), ticks = number32(), size = number32();
  number32();  // size on the network
  if (size > kLargest) file_.reject("a packet of " + std::to_string(size) + " bytes");
  packet.time = seconds + interfaces_.front().tick * ticks;
  packet.link = interfaces_.front().link;
  packet.bytes = file_.read(size, buffer_);
  return true;
}

bool CaptureFile::next_of_pcapng(CapturedPacket& packet) {
  constexpr std::uint32_t kFrame = 12;  // type, and size before and behind the body
  while (!file_.at_end()) {
    place_ = file_.place();
    const auto type = number32();
    if (type == kSection) {
      begin_section();
      continue;
    }
    const std::uint32_t size = number32();
    if (size < kFrame || size > kLargest || size % 4 != 0) {
      file_.reject("a block of " + std::to_string(size) + " bytes");
    }
    const std::string_view body = file_.read(size - kFrame, buffer_);
    if (number32() != size) file_.reject("a block of two sizes");
    if (type == kInterface) add_interface(body);
    if (type == kSimplePacket) file_.reject("packets without times: allowed: with times");
    if (type == kPacket && take_packet(body, packet)) return true;
  }
  return false;
}

/// Behind its type, which is the same in either byte order.
void CaptureFile::begin_section() {
  constexpr std::uint32_t kRead = 12, kLeast = 28;
  auto size = file_.number<std::uint32_t>();
  const auto order = file_.number<std::uint32_t>();
  swapped_ = order != kByteOrder;
  if (swapped_) size = swapped32(size);
  if ((swapped_ && swapped32(order) != kByteOrder) || size < kLeast || size > kLargest) {
    file_.reject("the file is cut short or damaged");
  }
  file_.skip(size - kRead);
  interfaces_.clear();
}

void CaptureFile::add_interface(std::string_view body) {
  constexpr std::size_t kFixed = 8, kHeader = 4;
  constexpr std::uint16_t kResolution = 9;
  if (body.size() < kFixed) file_.reject("a network without a type");
  Interface interface { number16(body, 0) };
  for (std::size_t at = kFixed; at + kHeader <= body.size();) {
    const std::uint16_t option = number16(body, at), length = number16(body, at + 2);
    if (option == 0 || at + kHeader + length > body.size()) break;
    if (option == kResolution && length == 1) {
      const auto resolution = static_cast<unsigned char>(body[at + kHeader]);
      const int digits = resolution & 0x7f;
      interface.tick = std::pow((resolution & 0x80) != 0 ? 2.0 : 10.0, -digits);
    }
    at += kHeader + (length + 3U) / 4 * 4;
  }
  interfaces_.push_back(interface);
}

bool CaptureFile::take_packet(std::string_view body, CapturedPacket& packet) const {
  constexpr std::size_t kFixed = 20;
  if (body.size() < kFixed) file_.reject("a packet without a size");
  const std::uint32_t network = number32(body, 0), size = number32(body, 12);
  if (network >= interfaces_.size() || size > body.size() - kFixed) {
    file_.reject("a packet of no network, or cut short");
  }
  const std::uint64_t ticks = std::uint64_t{number32(body, 4)} << 32 | number32(body, 8);
  packet.time = static_cast<double>(ticks) * interfaces_[network].tick;
  packet.link = interfaces_[network].link;
  packet.bytes = body.substr(kFixed, size);
  return true;
}

}  // namespace datasets
