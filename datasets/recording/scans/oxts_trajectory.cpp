#include "datasets/recording/scans/oxts_trajectory.h"

#include <cmath>
#include <numbers>

#include "datasets/recording/scans/scan_names.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

constexpr char kBadPose[] = "bad pose";
constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

bool is_oxts(const fs::path& folder) {
  return fs::is_directory(folder / "data") && fs::exists(folder / "timestamps.txt");
}

ldm::Pose oxts_pose(const std::vector<double>& numbers, double scale) {
  constexpr double kEarth = 6378137;  // radius [m]
  const double latitude = kDegree * numbers[0], longitude = kDegree * numbers[1];
  const auto turn = [](double angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis);
  };
  return {(turn(numbers[5], Eigen::Vector3d::UnitZ()) * turn(numbers[4], Eigen::Vector3d::UnitY()) *
           turn(numbers[3], Eigen::Vector3d::UnitX()))
              .toRotationMatrix(),
          {scale * kEarth * longitude,
           scale * kEarth * std::log(std::tan((std::numbers::pi / 2 + latitude) / 2)), numbers[2]}};
}

OxtsTrajectory::OxtsTrajectory(const fs::path& folder)
    : data_(folder / "data"), times_(folder / "timestamps.txt") {
  const std::int64_t lines = count_lines(folder / "timestamps.txt");
  const std::vector<std::string> names = scan_names(data_, ".txt");
  const auto of_lines = scan_of_each_line(names, lines);
  if (!of_lines) {
    throw ldm::InvalidInput((folder / "timestamps.txt").string() + ": " + std::to_string(lines) +
                            " lines: allowed: " + std::to_string(names.size()) +
                            ", one for each file of " + data_.string());
  }
  names_ = *of_lines;
}

bool OxtsTrajectory::advance() {
  while (next_ < names_.size()) {
    times_.advance();
    const std::string& name = names_[next_++];
    if (name.empty()) continue;
    file_ = data_ / name;
    return true;
  }
  return false;
}

StampedPose OxtsTrajectory::pose() {
  NumberLines lines(file_);
  lines.advance();
  const std::vector<double>& numbers = lines.numbers(kNumbers, kBadPose);
  constexpr double kNearPole = 85;  // [deg]: beyond, no Mercator map
  if (!(std::abs(numbers[0]) < kNearPole && std::abs(numbers[1]) <= 360)) {
    lines.reject(kBadPose, "no latitude and longitude in degrees");
  }
  const double time = times_.time(1, "bad time");
  const bool is_first = scale_ == 0;
  if (is_first) scale_ = std::cos(kDegree * numbers[0]);
  StampedPose result{time, oxts_pose(numbers, scale_)};
  if (is_first) first_ = result.pose.translation;
  result.pose.translation -= first_;
  return result;
}

}  // namespace datasets
