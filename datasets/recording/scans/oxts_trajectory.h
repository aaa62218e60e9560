#pragma once
/// Poses of the GPS/IMU of KITTI's raw recordings (Geiger et al., IJRR 2013; no paper section).
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/recording/scans/trajectory.h"

namespace datasets {

/// True for a folder with timestamps.txt and data/: `oxts` of a raw recording.
bool is_oxts(const std::filesystem::path& folder);

/// The pose that a line of 30 numbers says: position by the Mercator projection of KITTI's
/// development kit, in which x is east, y north and z up, R = Rz(yaw) Ry(pitch) Rx(roll). [m]
/// @param numbers latitude, longitude [deg], altitude [m], roll, pitch, yaw [rad], and others
/// @param scale cosine of the latitude of the recording's first pose
ldm::Pose oxts_pose(const std::vector<double>& numbers, double scale);

/// FOLDER/data/*.txt, one pose a file, at the times of FOLDER/timestamps.txt. The world begins
/// where the first pose is; its axes are east, north and up.
class OxtsTrajectory : public PoseSequence {
 public:
  /// @throws ldm::InvalidInput if a file cannot be read, or there are times too few or too many, of
  ///   which nothing tells which.
  explicit OxtsTrajectory(const std::filesystem::path& folder);

  bool has_times() const override { return true; }
  /// Times without a file are left out.
  bool advance() override;
  StampedPose pose() override;
  std::string place() const override { return file_.string(); }

 private:
  static constexpr std::size_t kNumbers = 30;

  std::filesystem::path data_, file_;
  NumberLines times_;
  std::vector<std::string> names_;  // of the files, by the lines of times
  std::size_t next_ = 0;
  double scale_ = 0;       // 0 before the first pose
  Eigen::Vector3d first_;  // [m]
};

}  // namespace datasets
