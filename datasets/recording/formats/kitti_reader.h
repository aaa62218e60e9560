#pragma once
/// Drives in the layout of KITTI's odometry benchmark (Geiger et al., CVPR 2012; no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// FOLDER/velodyne/*.bin in the natural order of their names, FOLDER/times.txt, FOLDER/poses.txt
/// and, optional, FOLDER/calib.txt. With the latter, whose line `Tr:` maps Velodyne to camera
/// coordinates, the poses are those of the camera, as KITTI's are, unless input.poses_of says
/// otherwise; without it those of the sensor. The world is the sensor's frame where the pose is the
/// identity: x forward, y left, z up.
/// @throws ldm::InvalidInput naming the file that is missing, cannot be read, or has lines too few.
std::unique_ptr<ScanReader> open_kitti(const std::filesystem::path& folder,
                                       const RecordingOptions& options);

/// Velodyne to camera coordinates, from the line `Tr:` or `Tr_velo_to_cam:` of a calib.txt.
/// @throws ldm::InvalidInput if there is no such line or its numbers are no rigid transform.
ldm::Pose read_kitti_calibration(const std::filesystem::path& file);

}  // namespace datasets
