#include "datasets/recording/scans/trajectory.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "datasets/files/text.h"
#include "datasets/quaternion_pose.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {
namespace {

constexpr char kBadPose[] = "bad pose";

}  // namespace

ldm::Pose interpolated(const ldm::Pose& a, const ldm::Pose& b, double share) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(a.rotation.transpose() * b.rotation));
  const Eigen::AngleAxisd part(share * turn.angle(), turn.axis());
  return {a.rotation * part.toRotationMatrix(),
          a.translation + share * (b.translation - a.translation)};
}

std::optional<Eigen::Matrix3d> nearest_rotation(const Eigen::Matrix3d& m) {
  constexpr double kFarthest = 0.05;
  if (!(m.cwiseAbs().maxCoeff() < 2)) return {};
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
  if (rotation.determinant() < 0 || (rotation - m).cwiseAbs().maxCoeff() > kFarthest) return {};
  return rotation;
}

std::optional<ldm::Pose> kitti_pose(const std::vector<double>& numbers) {
  using RowMajor = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> matrix(numbers.data());
  const auto rotation = nearest_rotation(matrix.leftCols<3>());
  if (!rotation) return {};
  return ldm::Pose{*rotation, matrix.col(3)};
}

TrajectoryFile::TrajectoryFile(const std::filesystem::path& file, double unit)
    : TrajectoryFile(NumberLines(file), unit) {}

TrajectoryFile::TrajectoryFile(NumberLines lines, double unit)
    : lines_(std::move(lines)), unit_(unit) {
  ended_ = !lines_.advance();
  const std::size_t words = lines_.words();
  has_times_ = words == kTumNumbers;
  if (words == kTumNumbers || words == kKittiNumbers) return;
  throw ldm::InvalidInput(
      lines_.place() + ": " + std::to_string(words) +
      " numbers: allowed: 8 (TUM: time x y z qx qy qz qw) or 12 (KITTI), between blanks");
}

bool TrajectoryFile::advance() {
  if (at_first_) {
    at_first_ = false;
  } else if (!ended_) {
    ended_ = !lines_.advance();
  }
  return !ended_;
}

StampedPose TrajectoryFile::pose() {
  if (ended_) lines_.reject("no pose", "the file ends: allowed: a pose for each scan");
  if (!has_times_) {
    const auto pose = kitti_pose(lines_.numbers(kKittiNumbers, kBadPose));
    if (!pose) lines_.reject(kBadPose, "the first three columns are no rotation matrix");
    return {0, *pose};
  }
  const auto& n = lines_.numbers(kTumNumbers, kBadPose);
  Eigen::Quaterniond q(n[7], n[4], n[5], n[6]);
  constexpr double kWrongNorm = 0.05;
  if (!(std::abs(q.norm() - 1) < kWrongNorm)) {
    lines_.reject(kBadPose, "quaternion of norm " + decimal(q.norm()) + ": allowed: 1");
  }
  q.normalize();
  return {unit_ * n[0], {q.toRotationMatrix(), {n[1], n[2], n[3]}}};
}

bool PoseTrack::add(const StampedPose& pose) {
  if (poses_.empty() || pose.time > poses_.back().time) {
    poses_.push_back(pose);
    return true;
  }
  if (pose.time < poses_.back().time) return false;
  poses_.back() = pose;
  return true;
}

std::optional<ldm::Pose> PoseTrack::at(double time, double longest_gap) {
  // Two always stay: they tell the velocity beyond the end.
  while (poses_.size() > 2 && poses_[1].time <= time - kMemory) poses_.pop_front();
  if (poses_.empty() || time < poses_.front().time - kReach || time > poses_.back().time + kReach) {
    return {};
  }
  if (poses_.size() == 1) return poses_.front().pose;
  const std::size_t first = before(time);
  const StampedPose &a = poses_[first], &b = poses_[first + 1];
  if (time == a.time) return a.pose;
  if (time == b.time) return b.pose;
  if (b.time - a.time > longest_gap) return {};
  return interpolated(a.pose, b.pose, (time - a.time) / (b.time - a.time));
}

std::string PoseTrack::around(double time) const {
  if (poses_.empty()) return "no poses";
  if (poses_.size() == 1) return "poses at " + decimal(poses_[0].time) + " s";
  const std::size_t first = before(time);
  return "poses at " + decimal(poses_[first].time) + " and " + decimal(poses_[first + 1].time) +
         " s";
}

std::size_t PoseTrack::before(double time) const {
  const auto later =
      std::upper_bound(poses_.begin() + 1, poses_.end() - 1, time,
                       [](double t, const StampedPose& pose) { return t < pose.time; });
  return static_cast<std::size_t>(later - poses_.begin()) - 1;
}

}  // namespace datasets
