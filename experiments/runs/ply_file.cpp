#include "experiments/runs/ply_file.h"

#include <array>
#include <bit>
#include <cstring>

namespace experiments {
namespace {

static_assert(std::endian::native == std::endian::little, "write_ply copies numbers as they are");

constexpr std::size_t kVertexBytes = 3 * sizeof(float) + 3 + sizeof(float) + sizeof(std::int32_t);

std::array<char, kVertexBytes> bytes_of(const PlyVertex& vertex) {
  std::array<char, kVertexBytes> bytes{};
  const std::uint8_t colour[] = {vertex.colour.red, vertex.colour.green, vertex.colour.blue};
  char* at = bytes.data();
  const auto append = [&at](const void* data, std::size_t size) {
    std::memcpy(at, data, size);
    at += size;
  };
  append(vertex.position.data(), 3 * sizeof(float));
  append(colour, sizeof colour);
  append(&vertex.occupancy, sizeof vertex.occupancy);
  append(&vertex.track, sizeof vertex.track);
  return bytes;
}

}  // namespace

void write_ply(const std::vector<PlyVertex>& vertices, const std::string& comment,
               std::ostream& out) {
  out << "ply\nformat binary_little_endian 1.0\n";
  if (!comment.empty()) out << "comment " << comment << '\n';
  out << "element vertex " << vertices.size() << '\n';
  for (const char* axis : {"x", "y", "z"}) out << "property float " << axis << '\n';
  for (const char* colour : {"red", "green", "blue"}) out << "property uchar " << colour << '\n';
  out << "property float occupancy\nproperty int track\nend_header\n";
  for (const PlyVertex& vertex : vertices) out.write(bytes_of(vertex).data(), kVertexBytes);
}

}  // namespace experiments
