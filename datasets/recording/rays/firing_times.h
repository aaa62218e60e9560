#pragma once
/// When a spinning LiDAR looked in a direction, by the times of its returns (no paper section).
#include <optional>
#include <vector>

#include "datasets/recording/rays/ray_angles.h"

namespace datasets {

/// Of one scan. Between two directions with returns time runs evenly; it is not known where they
/// were seen at about the same time as well as half a scan apart: where the turn ends.
class FiringTimes {
 public:
  /// @param points in the sensor's frame when each was measured [m]
  /// @param delays of the points [s], one each
  FiringTimes(const std::vector<ldm::Point>& points, const std::vector<float>& delays);

  /// The delay [s], or none if it is not known.
  std::optional<float> at(double azimuth) const;

 private:
  /// Delays of the returns in one step of azimuth.
  struct Bin {
    float first = 0, last = 0;
    bool used = false;
  };
  static constexpr std::size_t kBins = 720;

  std::optional<float> between(const Bin& a, const Bin& b, float share) const;

  std::vector<Bin> bins_;
  std::vector<std::size_t> before_, after_;  ///< the nearest used bin, at or before (after) each
  float longest_ = 0;                        ///< between delays of one direction [s]
};

}  // namespace datasets
