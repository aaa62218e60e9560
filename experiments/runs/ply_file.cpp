#include "experiments/runs/ply_file.h"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <sstream>

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

PlyVertex vertex_of(const std::array<char, kVertexBytes>& bytes) {
  PlyVertex vertex;
  const char* at = bytes.data();
  const auto take = [&at](void* data, std::size_t size) {
    std::memcpy(data, at, size);
    at += size;
  };
  take(vertex.position.data(), 3 * sizeof(float));
  take(&vertex.colour.red, 1);
  take(&vertex.colour.green, 1);
  take(&vertex.colour.blue, 1);
  take(&vertex.occupancy, sizeof vertex.occupancy);
  take(&vertex.track, sizeof vertex.track);
  return vertex;
}

void write_header(std::size_t vertices, const std::string& comment, std::ostream& out) {
  out << "ply\nformat binary_little_endian 1.0\n";
  if (!comment.empty()) out << "comment " << comment << '\n';
  out << "element vertex " << vertices << '\n';
  for (const char* axis : {"x", "y", "z"}) out << "property float " << axis << '\n';
  for (const char* colour : {"red", "green", "blue"}) out << "property uchar " << colour << '\n';
  out << "property float occupancy\nproperty int track\nend_header\n";
}

}  // namespace

void write_ply(const std::vector<PlyVertex>& vertices, const std::string& comment,
               std::ostream& out) {
  write_header(vertices.size(), comment, out);
  for (const PlyVertex& vertex : vertices) out.write(bytes_of(vertex).data(), kVertexBytes);
}

PlyFile read_ply(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream header, expected;
  std::string line, comment;
  std::size_t count = 0;
  while (line != "end_header" && std::getline(in, line)) {
    header << line << '\n';
    if (line.starts_with("comment ")) comment = line.substr(line.find(' ') + 1);
    if (line.starts_with("element vertex ")) std::istringstream(line.substr(15)) >> count;
  }
  write_header(count, comment, expected);
  PlyFile ply;
  std::array<char, kVertexBytes> bytes{};
  for (std::size_t i = 0; i < count && in.read(bytes.data(), kVertexBytes); ++i) {
    ply.vertices.push_back(vertex_of(bytes));
  }
  if (header.str() != expected.str() || ply.vertices.size() != count) {
    throw ldm::InvalidInput(
        "no map of a run: allowed: a file as `ldm run --save-frames` writes it");
  }
  std::string word;
  if (!comment.empty()) {
    std::istringstream(comment) >> word >> ply.origin.x() >> ply.origin.y() >> ply.origin.z();
  }
  return ply;
}

}  // namespace experiments
