#pragma once
/// The simulated LiDAR: beam pattern, range image, and its projection to points (paper Sec. 4.1.1,
/// 4.2.1).
#include <cstdint>
#include <vector>

#include "ldm/types.h"

namespace datasets {

/// Beam pattern and noise of a spinning LiDAR. All beams of a scan are fired at one instant.
struct LidarModel {
  std::vector<double> elevations;  ///< of the channels, ascending [rad]
  std::int32_t azimuths =
      1024;                ///< firings a revolution; firing j looks at -pi + 2 pi j / azimuths
  double rate = 10;        ///< revolutions a second [Hz]
  double min_range = 0.3;  ///< shorter returns are lost [m]
  double max_range = 100;  ///< longer returns are lost [m]; at most 65535 quanta
  double range_sigma = 0;  ///< standard deviation of the range noise [m]
};

/// Ranges in quanta of 2 mm, 0 for no return; channel-major: [channel * azimuths + firing].
/// The unit is what MRPT's CObservationRotatingScan stores, so that logs read back bit for bit.
struct RangeImage {
  static constexpr double kQuantum = 0.002;  ///< [m]
  std::int32_t channels = 0;
  std::int32_t azimuths = 0;
  std::vector<std::uint16_t> ranges;
};

/// Fill `scan.points` and `scan.no_returns` (sensor frame: x forward, y left, z up) from an image.
/// The same image gives the same bits, whether simulated or read from a log.
/// @throws ldm::InvalidInput unless the image has the model's number of channels and azimuths.
void project(const LidarModel& model, const RangeImage& image, ldm::Scan& scan);

/// The unit directions of a model's rays, kept as cosine and sine of each channel and firing.
/// Its `project` spares repeated scans the making of the table.
class BeamTable {
 public:
  explicit BeamTable(const LidarModel& model);

  std::size_t channels() const { return elevation_.size(); }
  std::size_t azimuths() const { return azimuth_.size(); }
  /// Unit vector, sensor frame.
  Eigen::Vector3d direction(std::size_t channel, std::size_t firing) const {
    const Angle &e = elevation_[channel], &a = azimuth_[firing];
    return {e.cos * a.cos, e.cos * a.sin, e.sin};
  }
  /// As the free function.
  void project(const RangeImage& image, ldm::Scan& scan) const;

 private:
  struct Angle {
    double cos, sin;
  };
  std::vector<Angle> elevation_;
  std::vector<Angle> azimuth_;
};

}  // namespace datasets
