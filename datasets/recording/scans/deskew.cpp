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

/// Samples at equal steps from the first delay to the last.
class Motion {
 public:
  Motion(float first, float last) : first_(first), whole_(last - first) {}

  /// @return false if there is no pose at one of the steps
  bool sample(const ldm::Pose& T_world_sensor,
              const std::function<std::optional<ldm::Pose>(double)>& sensor_at) {
    constexpr double kStep = 0.005;  // [s]
    const double begin = static_cast<double>(first_), length = static_cast<double>(whole_);
    steps_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / kStep)));
    const double step = length / static_cast<double>(steps_);
    const ldm::Pose T_scan_world = inverse(T_world_sensor);
    for (std::size_t i = 0; i <= steps_; ++i) {
      const std::optional<ldm::Pose> pose = sensor_at(begin + step * static_cast<double>(i));
      if (!pose) return false;
      const ldm::Pose T_scan_sensor = composed(T_scan_world, *pose);
      samples_.push_back(
          {T_scan_sensor.rotation.cast<float>(), T_scan_sensor.translation.cast<float>()});
    }
    return true;
  }

  ldm::Point moved(const ldm::Point& p, float delay) const {
    const auto [a, b, share] = around(delay);
    return (1 - share) * (a.rotation * p + a.translation) +
           share * (b.rotation * p + b.translation);
  }
  ldm::Point turned(const ldm::Point& ray, float delay) const {
    const auto [a, b, share] = around(delay);
    return ((1 - share) * (a.rotation * ray) + share * (b.rotation * ray)).normalized();
  }
  /// How far the sensor is from where it is at the scan's time [m].
  float way(float delay) const {
    const auto [a, b, share] = around(delay);
    return ((1 - share) * a.translation + share * b.translation).norm();
  }

 private:
  struct Around {
    const Sample &a, &b;
    float share;
  };
  Around around(float delay) const {
    // Of the whole, and only then of a step: the whole may be too short for a number of steps a
    // second.
    const auto count = static_cast<float>(steps_);
    const float place = whole_ > 0 ? (delay - first_) / whole_ * count : 0;
    const std::size_t k = std::min(static_cast<std::size_t>(place), steps_ - 1);
    return {samples_[k], samples_[k + 1], place - static_cast<float>(k)};
  }

  float first_, whole_;  // [s]
  std::size_t steps_ = 1;
  std::vector<Sample> samples_;
};

}  // namespace

bool deskew(const std::vector<float>& delays, const ldm::Pose& T_world_sensor,
            const std::function<std::optional<ldm::Pose>(double)>& sensor_at,
            std::vector<ldm::Point>& points, TimedRays& rays) {
  if (delays.empty()) return true;
  const auto [first, last] = std::minmax_element(delays.begin(), delays.end());
  Motion motion(*first, *last);
  if (!motion.sample(T_world_sensor, sensor_at)) return false;
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = motion.moved(points[i], delays[i]);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rays.rays.size(); ++i) {
    const float delay = rays.delays[i];
    if (motion.way(delay) > kFarthestRay) continue;
    rays.rays[kept] = motion.turned(rays.rays[i], delay);
    rays.delays[kept++] = delay;
  }
  rays.rays.resize(kept);
  rays.delays.resize(kept);
  return true;
}

}  // namespace datasets
