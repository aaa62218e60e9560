#pragma once
/// Returns of a LiDAR of 16 channels and 1024 firings from boxes, with noise: for the tests of
/// objects.
#include <cmath>
#include <random>
#include <vector>

#include "tests/ldm/box_scans.h"

namespace ldm {

class NoisyLidar {
 public:
  /// @param range_sigma [m]
  explicit NoisyLidar(double range_sigma = 0.02) : noise_(0, range_sigma) {}

  /// World frame [m].
  std::vector<Eigen::Vector3d> returns(const Eigen::Vector3d& sensor,
                                       const std::vector<Box>& boxes) {
    constexpr double kPi = 3.14159265358979323846;
    std::vector<Eigen::Vector3d> points;
    for (int channel = 0; channel < 16; ++channel) {
      const double elevation = (channel - 7.5) * 2.2 * kPi / 180;
      for (int firing = 0; firing < 1024; ++firing) {
        const double azimuth = 2 * kPi * firing / 1024;
        const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        std::optional<double> nearest;
        for (const Box& box : boxes) {
          const std::optional<double> range = range_to(box, sensor, ray);
          if (range && (!nearest || *range < *nearest)) nearest = range;
        }
        if (nearest) points.push_back(sensor + (*nearest + noise_(random_)) * ray);
      }
    }
    return points;
  }

 private:
  std::mt19937 random_{1};
  std::normal_distribution<double> noise_;
};

}  // namespace ldm
