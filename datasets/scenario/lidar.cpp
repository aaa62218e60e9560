#include "datasets/scenario/lidar.h"

#include <cmath>
#include <numbers>
#include <string>

namespace datasets {

BeamTable::BeamTable(const LidarModel& model) {
  for (const double elevation : model.elevations) {
    elevation_.push_back({std::cos(elevation), std::sin(elevation)});
  }
  for (std::int32_t firing = 0; firing < model.azimuths; ++firing) {
    const double azimuth = -std::numbers::pi + 2 * std::numbers::pi * firing / model.azimuths;
    azimuth_.push_back({std::cos(azimuth), std::sin(azimuth)});
  }
}

void BeamTable::project(const RangeImage& image, ldm::Scan& scan) const {
  if (image.ranges.size() != channels() * azimuths() ||
      static_cast<std::size_t>(image.channels) != channels()) {
    throw ldm::InvalidInput(
        "range image = " + std::to_string(image.channels) + " x " + std::to_string(image.azimuths) +
        ": allowed: " + std::to_string(channels()) + " x " + std::to_string(azimuths()));
  }
  // Room for all rays in both lists, so that writing needs no test of the capacity.
  scan.points.resize(image.ranges.size());
  scan.no_returns.resize(image.ranges.size());
  ldm::Point* point = scan.points.data();
  ldm::Point* no_return = scan.no_returns.data();
  const std::uint16_t* range = image.ranges.data();
  for (std::size_t channel = 0; channel < channels(); ++channel) {
    for (std::size_t firing = 0; firing < azimuths(); ++firing, ++range) {
      const Eigen::Vector3d ray = direction(channel, firing);
      if (*range == 0) {
        *no_return++ = ray.cast<float>();
      } else {
        *point++ = (*range * RangeImage::kQuantum * ray).cast<float>();
      }
    }
  }
  scan.points.resize(static_cast<std::size_t>(point - scan.points.data()));
  scan.no_returns.resize(static_cast<std::size_t>(no_return - scan.no_returns.data()));
}

void project(const LidarModel& model, const RangeImage& image, ldm::Scan& scan) {
  BeamTable(model).project(image, scan);
}

}  // namespace datasets
