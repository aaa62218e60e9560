#include "datasets/recording/formats/bin_scans.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "datasets/recording/formats/scan_folder_reader.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "scans are read as they lie in the file");

float number_at(const std::string& content, std::size_t index) {
  float number = 0;
  std::memcpy(&number, content.data() + sizeof number * index, sizeof number);
  return number;
}

/// True if every fifth number may be that of a ring.
bool has_rings(const std::string& content) {
  constexpr float kMostRings = 256;
  for (std::size_t i = 4; i < content.size() / sizeof(float); i += 5) {
    const float ring = number_at(content, i);
    if (!(ring >= 0 && ring < kMostRings && ring == std::floor(ring))) return false;
  }
  return true;
}

/// True if every fourth number may be an intensity.
bool has_intensities(const std::string& content) {
  for (std::size_t i = 3; i < content.size() / sizeof(float); i += 4) {
    if (!(number_at(content, i) >= 0)) return false;
  }
  return true;
}

/// How many floats a point has, by the first scan. A file of any number of points in 32 rings may
/// be one of four floats by its size.
std::size_t columns_of(const std::string& content, const std::string& name) {
  constexpr std::size_t kFour = 4 * sizeof(float), kFive = 5 * sizeof(float);
  const bool four = content.size() % kFour == 0;
  if (content.empty() || content.size() % kFive != 0 || !has_rings(content)) return 4;
  if (!four || !has_intensities(content)) return 5;
  throw ldm::InvalidInput(name +
                          ": its points may have 4 or 5 numbers: allowed: --set "
                          "input.bin_columns=4 (KITTI) or 5 (nuScenes)");
}

/// Reads one scan after the other.
class BinLoader {
 public:
  explicit BinLoader(BinColumns columns) {
    if (columns != BinColumns::kAuto) columns_ = columns == BinColumns::kFour ? 4 : 5;
  }
  void operator()(const fs::path& file, std::vector<ldm::Point>& points) {
    read_scan_file(file, content_);
    if (columns_ == 0) columns_ = columns_of(content_, file.string());
    parse_bin_scan(content_, file.string(), columns_, points);
  }

 private:
  std::size_t columns_ = 0;  // 0: not known yet
  std::string content_;
};

}  // namespace

std::function<void(const fs::path&, std::vector<ldm::Point>&)> bin_loader(BinColumns columns) {
  return BinLoader(columns);
}

void parse_bin_scan(const std::string& content, const std::string& name, std::size_t columns,
                    std::vector<ldm::Point>& points) {
  const std::size_t point_bytes = columns * sizeof(float);
  if (content.empty() || content.size() % point_bytes != 0) {
    throw BrokenFrame("broken scan", name + ": byte " + std::to_string(content.size()) +
                                         ": the file ends: allowed: " +
                                         std::to_string(point_bytes) + " bytes for each point");
  }
  points.reserve(points.size() + content.size() / point_bytes);
  for (std::size_t i = 0; i < content.size() / sizeof(float); i += columns) {
    points.emplace_back(number_at(content, i), number_at(content, i + 1),
                        number_at(content, i + 2));
  }
}

}  // namespace datasets
