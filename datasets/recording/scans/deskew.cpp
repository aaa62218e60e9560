#include "datasets/recording/scans/deskew.h"

#include <algorithm>
#include <cmath>

#include "datasets/quaternion_pose.h"

namespace datasets {
namespace {

/// T_scan_sensor at one delay.
struct Sample {
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;
};

}  // namespace

bool deskew(const std::vector<float>& delays, const ldm::Pose& T_world_sensor,
            const std::function<std::optional<ldm::Pose>(double)>& sensor_at,
            std::vector<ldm::Point>& points) {
  constexpr double kStep = 0.005;  // [s]
  if (delays.empty()) return true;
  const auto [first, last] = std::minmax_element(delays.begin(), delays.end());
  const float whole = *last - *first;
  const double begin = static_cast<double>(*first), length = static_cast<double>(whole);
  const auto steps = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / kStep)));
  const double step = length / static_cast<double>(steps);
  std::vector<Sample> samples;
  const ldm::Pose T_scan_world = inverse(T_world_sensor);
  for (std::size_t i = 0; i <= steps; ++i) {
    const std::optional<ldm::Pose> pose = sensor_at(begin + step * static_cast<double>(i));
    if (!pose) return false;
    const ldm::Pose T_scan_sensor = composed(T_scan_world, *pose);
    samples.push_back(
        {T_scan_sensor.rotation.cast<float>(), T_scan_sensor.translation.cast<float>()});
  }
  // Of the whole, and only then of a step: the whole may be too short for a number of steps a
  // second.
  const auto count = static_cast<float>(steps);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float place = whole > 0 ? (delays[i] - *first) / whole * count : 0;
    const std::size_t k = std::min(static_cast<std::size_t>(place), steps - 1);
    const float share = place - static_cast<float>(k);
    const Sample &a = samples[k], &b = samples[k + 1];
    const ldm::Point p = points[i];
    points[i] =
        (1 - share) * (a.rotation * p + a.translation) + share * (b.rotation * p + b.translation);
  }
  return true;
}

}  // namespace datasets
