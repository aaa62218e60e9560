#pragma once
/// Where the sensor or vehicle was: trajectory files, and poses between their poses (no paper
/// section).
#include <Eigen/Geometry>
#include <deque>
#include <optional>
#include <string>

#include "datasets/recording/scans/number_lines.h"
#include "ldm/types.h"

namespace datasets {

struct StampedPose {
  double time = 0;  ///< [s]
  ldm::Pose pose;
};

/// Between a (share 0) and b (share 1): position on the line, rotation at constant rate; beyond
/// them for other shares.
ldm::Pose interpolated(const ldm::Pose& a, const ldm::Pose& b, double share);

/// The nearest rotation matrix; none if `m` is far from every rotation (element by element more
/// than 0.05), as a matrix of other numbers is.
std::optional<Eigen::Matrix3d> nearest_rotation(const Eigen::Matrix3d& m);

/// A pose as KITTI writes it: 3 x 4 matrix, row by row; none if it holds no rotation.
inline constexpr std::size_t kKittiNumbers = 12;
std::optional<ldm::Pose> kitti_pose(const std::vector<double>& numbers);

/// Poses one after the other, in order of time.
class PoseSequence {
 public:
  virtual ~PoseSequence() = default;

  virtual bool has_times() const = 0;
  /// To the next pose (in the beginning, to the first); false at the end.
  virtual bool advance() = 0;
  /// With time 0 if the poses have no times.
  /// @throws BrokenFrame naming place and what is wrong.
  virtual StampedPose pose() = 0;
  /// Where that pose stands, for messages.
  virtual std::string place() const = 0;
};

/// Reads a trajectory line by line: TUM's (time x y z qx qy qz qw) or KITTI's (three rows of a
/// 3 x 4 matrix, without a time). Lengths in metres.
class TrajectoryFile : public PoseSequence {
 public:
  static constexpr std::size_t kTumNumbers = 8;

  /// The first line tells which of the two it is.
  /// @param unit of its times [s]
  /// @throws ldm::InvalidInput if the file cannot be read, or its first line is neither.
  explicit TrajectoryFile(const std::filesystem::path& file, double unit = 1);
  explicit TrajectoryFile(NumberLines lines, double unit = 1);

  bool has_times() const override { return has_times_; }
  bool advance() override;
  StampedPose pose() override;
  std::string place() const override { return lines_.place(); }

 private:
  NumberLines lines_;
  double unit_;
  bool has_times_ = false;
  bool at_first_ = true;  // the constructor stands on the first line already
  bool ended_ = false;
};

/// The stretch of a trajectory around the present time; older poses are forgotten.
class PoseTrack {
 public:
  /// How far back from the latest time that was asked for another one may be [s].
  static constexpr double kMemory = 2;
  /// Beyond its ends a track goes on this long at constant velocity [s]: stamps are rounded, and
  /// the pose of the first or last sweep may be stamped at its middle.
  static constexpr double kReach = 0.15;

  /// Poses come in order of time; one at the time of the last takes its place.
  /// @return false, and nothing is done, if it lies before the last one
  bool add(const StampedPose& pose);
  /// True if a pose at `time` or later has been added.
  bool covers(double time) const { return !poses_.empty() && poses_.back().time >= time; }
  bool empty() const { return poses_.empty(); }

  /// The pose at `time`; times go back by no more than kMemory from call to call. None where the
  /// track has a gap of more than `longest_gap` [s] there, or `time` lies beyond its reach.
  std::optional<ldm::Pose> at(double time, double longest_gap);
  /// For messages: the times of the poses around.
  std::string around(double time) const;

 private:
  /// The first of two poses around `time`, or of the two nearest; there must be two.
  std::size_t before(double time) const;

  std::deque<StampedPose> poses_;
};

}  // namespace datasets
