#include "datasets/recording/formats/kitti_raw_reader.h"

#include "datasets/quaternion_pose.h"
#include "datasets/recording/formats/bin_scans.h"
#include "datasets/recording/formats/scan_folder_reader.h"
#include "datasets/recording/scans/scan_names.h"

namespace datasets {

namespace fs = std::filesystem;

bool is_kitti_raw(const fs::path& folder) {
  return fs::is_directory(folder / "velodyne_points" / "data");
}

std::unique_ptr<ScanReader> open_kitti_raw(const fs::path& folder,
                                           const RecordingOptions& options) {
  const fs::path velodyne = folder / "velodyne_points";
  ScanFolder scans;
  scans.folder = velodyne / "data";
  scans.names = scan_names(scans.folder, kBinEnding);
  scans.load = bin_loader(options.input.bin_columns);
  scans.timeline = timeline_files(velodyne / "timestamps.txt", folder / "oxts", options);
  if (!options.poses) scans.poses_of = PosesOf::kVehicle;
  // The files of a day's calibration lie beside its drives.
  for (const fs::path& place : {folder, fs::weakly_canonical(folder).parent_path()}) {
    const fs::path calibration = place / "calib_imu_to_velo.txt";
    if (scans.T_uav_sensor || !fs::exists(calibration)) continue;
    scans.T_uav_sensor = inverse(read_rigid_calibration(calibration));
  }
  return std::make_unique<ScanFolderReader>(std::move(scans), options);
}

ldm::Pose read_rigid_calibration(const fs::path& file) {
  std::vector<double> rotation, translation;
  for (NumberLines lines(file); lines.advance();) {
    const std::string key = lines.text().substr(0, lines.text().find(':'));
    if (key != "R" && key != "T") continue;
    lines.drop(2);
    if (key == "R") rotation = lines.numbers(9, "calibration");
    if (key == "T") translation = lines.numbers(3, "calibration");
  }
  if (rotation.empty() || translation.empty()) {
    throw ldm::InvalidInput(file.string() +
                            ": has no lines `R:` and `T:`: allowed: R: and 9 numbers, T: and 3");
  }
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const auto nearest = nearest_rotation(Eigen::Map<const RowMajor>(rotation.data()));
  if (!nearest) throw ldm::InvalidInput(file.string() + ": R is no rotation matrix");
  return {*nearest, Eigen::Map<const Eigen::Vector3d>(translation.data())};
}

}  // namespace datasets
