#include "datasets/recording/formats/kitti_reader.h"

#include "datasets/quaternion_pose.h"
#include "datasets/recording/formats/bin_scans.h"
#include "datasets/recording/formats/scan_folder_reader.h"
#include "datasets/recording/scans/scan_names.h"

namespace datasets {

namespace fs = std::filesystem;

std::unique_ptr<ScanReader> open_kitti(const fs::path& folder, const RecordingOptions& options) {
  ScanFolder scans;
  scans.folder = folder / "velodyne";
  scans.names = scan_names(scans.folder, kBinEnding);
  scans.load = bin_loader(options.input.bin_columns);
  scans.timeline = timeline_files(folder / "times.txt", folder / "poses.txt", options);
  const PosesOf of = options.input.poses_of;
  const bool camera = of == PosesOf::kAuto || of == PosesOf::kCamera;
  if (const fs::path calibration = folder / "calib.txt"; camera && fs::exists(calibration)) {
    scans.poses_of = PosesOf::kCamera;
    scans.T_sensor_camera = inverse(read_kitti_calibration(calibration));
  }
  return std::make_unique<ScanFolderReader>(std::move(scans), options);
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
