#include "datasets/recording/formats/kitti_reader.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

#include "datasets/quaternion_pose.h"
#include "datasets/recording/formats/scan_folder_reader.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "scans are read as they lie in the file");

constexpr std::string_view kScanEnding = ".bin";
constexpr std::size_t kMaxDigits = 12;

/// How the scans of a folder are numbered.
struct Numbering {
  std::int64_t count = 0;  ///< the number after the last
  std::size_t digits = 0;
};

/// @throws ldm::InvalidInput if there is no scan, or one whose name is no number.
Numbering numbering_of(const fs::path& folder) {
  Numbering result;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != kScanEnding) continue;
    const std::string stem = entry.path().stem().string();
    std::int64_t number = -1;
    const auto [end, bad] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
    if (bad != std::errc{} || end != stem.data() + stem.size() || number < 0 ||
        stem.size() > kMaxDigits || (result.digits != 0 && result.digits != stem.size())) {
      throw ldm::InvalidInput(entry.path().string() +
                              ": allowed: numbers of equally many digits as names of scans");
    }
    result = {std::max(result.count, number + 1), stem.size()};
  }
  if (error) {
    throw ldm::InvalidInput(folder.string() + ": cannot be read (" + error.message() + ")");
  }
  if (result.count == 0) throw ldm::InvalidInput(folder.string() + ": has no scans (NUMBER.bin)");
  return result;
}

fs::path scan_file(const fs::path& folder, std::int64_t number, std::size_t digits) {
  const std::string text = std::to_string(number);
  std::string name(digits - std::min(digits, text.size()), '0');
  return folder / name.append(text).append(kScanEnding);
}

}  // namespace

std::unique_ptr<ScanReader> open_kitti(const fs::path& folder, const RecordingOptions& options) {
  ScanFolder scans;
  const fs::path velodyne = folder / "velodyne";
  const Numbering numbering = numbering_of(velodyne);
  scans.scans = numbering.count;
  scans.file_of = [velodyne, digits = numbering.digits](std::int64_t number) {
    return scan_file(velodyne, number, digits);
  };
  scans.load = [content = std::string()](const fs::path& file,
                                         std::vector<ldm::Point>& points) mutable {
    read_scan_file(file, content);
    parse_kitti_scan(content, file.string(), points);
  };
  scans.timeline = timeline_files(folder, options);
  scans.poses_of = options.input.poses_of;
  if (const fs::path calibration = folder / "calib.txt"; fs::exists(calibration)) {
    if (scans.poses_of == PosesOf::kVehicle) {
      throw ldm::InvalidInput(calibration.string() +
                              ": the poses are those of its camera: allowed: input.poses_of = "
                              "sensor, or no such file");
    }
    scans.T_sensor_camera = inverse(read_kitti_calibration(calibration));
  }
  return std::make_unique<ScanFolderReader>(std::move(scans), options.input, !options.keep_going);
}

void parse_kitti_scan(const std::string& content, const std::string& name,
                      std::vector<ldm::Point>& points) {
  constexpr std::size_t kPointBytes = 4 * sizeof(float);
  if (content.empty() || content.size() % kPointBytes != 0) {
    throw BrokenFrame("broken scan", name + ": byte " + std::to_string(content.size()) +
                                         ": the file ends: allowed: 16 bytes for each point");
  }
  points.reserve(points.size() + content.size() / kPointBytes);
  for (std::size_t at = 0; at < content.size(); at += kPointBytes) {
    float xyz[3];
    std::memcpy(xyz, content.data() + at, sizeof xyz);
    points.emplace_back(xyz[0], xyz[1], xyz[2]);
  }
}

ldm::Pose read_kitti_calibration(const fs::path& file) {
  NumberLines lines(file);
  while (lines.advance()) {
    const std::size_t colon = lines.text().find(':');
    const std::string key = lines.text().substr(0, colon);
    if (colon == std::string::npos || (key != "Tr" && key != "Tr_velo_to_cam")) continue;
    lines.drop(colon + 1);
    const auto transform = kitti_pose(lines.numbers(kKittiNumbers, "calibration"));
    if (!transform) lines.reject("calibration", "the first three columns are no rotation matrix");
    return *transform;
  }
  throw ldm::InvalidInput(file.string() +
                          ": has no line `Tr:`: allowed: Tr: and 12 numbers, Velodyne to camera");
}

}  // namespace datasets
