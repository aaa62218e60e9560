#include "datasets/recording/formats/bin_folder_reader.h"

#include <algorithm>
#include <optional>

#include "datasets/recording/formats/bin_scans.h"
#include "datasets/recording/formats/nuscenes_tables.h"
#include "datasets/recording/formats/scan_folder_reader.h"
#include "datasets/recording/scans/scan_names.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

/// The last number in a name as a time of the clock, in seconds with all their digits.
std::optional<std::string> time_in(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789";
  constexpr std::size_t kSecondDigits = 10, kMicroseconds = 16, kNanoseconds = 19;
  const std::size_t end = name.find_last_of(kDigits) + 1;
  const std::size_t begin = end == 0 ? 0 : name.find_last_not_of(kDigits, end - 1) + 1;
  if (end - begin != kMicroseconds && end - begin != kNanoseconds) return {};
  return name.substr(begin, kSecondDigits) + "." +
         name.substr(begin + kSecondDigits, end - begin - kSecondDigits);
}

/// A line for each scan; empty if a name tells no time. Sorts the scans by it.
std::string times_in(std::vector<std::string>& names) {
  std::vector<std::pair<std::string, std::string>> scans;
  for (const std::string& name : names) {
    const auto time = time_in(name);
    if (!time) return {};
    scans.emplace_back(*time, name);
  }
  std::sort(scans.begin(), scans.end());
  std::string times;
  names.clear();
  for (const auto& [time, name] : scans) {
    times += time + "\n";
    names.push_back(name);
  }
  return times;
}

}  // namespace

std::unique_ptr<ScanReader> open_bin_folder(const fs::path& folder,
                                            const RecordingOptions& options) {
  ScanFolder scans;
  scans.folder = folder;
  scans.names = scan_names(folder, kBinEnding);
  scans.load = bin_loader(options.input.bin_columns);
  std::optional<fs::path> tables;
  const bool still = options.input.poses == PoseSource::kStill;
  if (!still && !options.poses && !fs::exists(folder / "poses.txt"))
    tables = nuscenes_tables(folder);
  if (tables) {
    scans.timeline.times = options.times;
    if (!options.times && fs::exists(folder / "times.txt")) {
      scans.timeline.times = folder / "times.txt";
    }
  } else {
    scans.timeline = timeline_files(folder / "times.txt", folder / "poses.txt", options);
  }
  if (!scans.timeline.times) scans.timeline.times_of_names = times_in(scans.names);
  if (tables) {
    NuscenesPoses poses = read_nuscenes_poses(*tables, scans.names);
    scans.poses = std::move(poses.T_world_vehicle);
    scans.poses_of = PosesOf::kVehicle;
    scans.T_uav_sensor = poses.T_vehicle_sensor;
  }
  return std::make_unique<ScanFolderReader>(std::move(scans), options);
}

}  // namespace datasets
