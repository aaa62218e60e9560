#pragma once
/// Drives in the layout of KITTI's raw recordings (Geiger et al., IJRR 2013; no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// True for a folder with velodyne_points/data/.
bool is_kitti_raw(const std::filesystem::path& folder);

/// FOLDER/velodyne_points/data/*.bin at the times of velodyne_points/timestamps.txt, when the
/// scanner looked forward; the vehicle is the GPS/IMU, whose poses come from FOLDER/oxts. Where the
/// scanner sits on it says calib_imu_to_velo.txt in FOLDER or the folder of the day around it, else
/// input.sensor.*.
/// @throws ldm::InvalidInput naming the file that is missing, cannot be read, or has lines too few.
std::unique_ptr<ScanReader> open_kitti_raw(const std::filesystem::path& folder,
                                           const RecordingOptions& options);

/// The transform of the lines `R:` and `T:` of a calib_*_to_*.txt.
/// @throws ldm::InvalidInput if there are no such lines or the numbers are no rigid transform.
ldm::Pose read_rigid_calibration(const std::filesystem::path& file);

}  // namespace datasets
