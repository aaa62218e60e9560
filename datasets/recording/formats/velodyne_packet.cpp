#include "datasets/recording/formats/velodyne_packet.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace datasets {
namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;
using Packet = Scan::TVelodyneRawPacket;
using Laser = mrpt::obs::VelodyneCalibration::PerLaserCalib;

constexpr int kTurn = Scan::ROTATION_MAX_UNITS;  // [0.01 deg]
constexpr double kDegree = std::numbers::pi / 180;

/// A distance in units of 2 mm. MRPT's own way to it is by a reference, for which most are not
/// aligned.
unsigned distance_of(const Scan::laser_return_t& laser_return) {
  std::uint16_t distance = 0;
  std::memcpy(&distance, &laser_return, sizeof distance);
  return distance;
}

/// How the returns of a block lie in it, and when they are fired, in parts of the time between two
/// blocks.
struct Model {
  std::size_t lasers;
  double per_firing, per_laser;
};
constexpr Model kModels[] = {{16, 0.5, 2.304 / 110.592}, {32, 0, 1.152 / 46.08}, {64, 0, 0}};

const Model* model_of(const mrpt::obs::VelodyneCalibration& calibration) {
  const auto found = std::find_if(std::begin(kModels), std::end(kModels), [&](const Model& model) {
    return model.lasers == calibration.laser_corrections.size();
  });
  return found == std::end(kModels) ? nullptr : found;
}

bool is_whole(const Packet& packet, const Model& model) {
  return std::all_of(std::begin(packet.blocks), std::end(packet.blocks), [&](const auto& block) {
    const bool lower = block.header() == Scan::LOWER_BANK && model.lasers == 64;
    return (block.header() == Scan::UPPER_BANK || lower) && block.rotation() < kTurn;
  });
}

/// How far the sensor turns from a block to the next one: what is most common [0.01 deg].
double step_of(const Packet& packet) {
  std::vector<int> steps;
  for (int k = 1; k < Scan::BLOCKS_PER_PACKET; ++k) {
    const int step = packet.blocks[k].rotation() - packet.blocks[k - 1].rotation();
    if (step != 0) steps.push_back(step < 0 ? step + kTurn : step);
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

ldm::Point point_of(double range, double azimuth, const Laser& laser) {
  const double along = range * laser.cosVertCorrection;
  const double a = kDegree * (azimuth - laser.azimuthCorrection);
  const double across = laser.horizontalOffsetCorrection;
  return Eigen::Vector3d(along * std::cos(a) + across * std::sin(a),
                         -along * std::sin(a) + across * std::cos(a),
                         range * laser.sinVertCorrection + laser.verticalOffsetCorrection)
      .cast<float>();
}

}  // namespace

bool take_velodyne_points(const Packet& packet, const mrpt::obs::VelodyneCalibration& calibration,
                          std::vector<VelodynePoint>& points) {
  const Model* const model = model_of(calibration);
  if (model == nullptr || !is_whole(packet, *model)) return false;
  const double step = step_of(packet);
  for (const auto& block : packet.blocks) {
    const std::size_t bank = block.header() == Scan::LOWER_BANK ? 32 : 0;
    for (std::size_t k = 0; k < Scan::SCANS_PER_BLOCK; ++k) {
      const std::size_t laser = (bank + k) % model->lasers;
      const std::size_t firing = k / model->lasers;
      const std::size_t place = k % model->lasers;
      const Laser& correction = calibration.laser_corrections[laser];
      const unsigned distance = distance_of(block.laser_returns[k]);
      if (distance == 0) continue;
      const double range = 0.002 * distance + correction.distanceCorrection;
      const double azimuth =
          0.01 * (block.rotation() + step * (static_cast<double>(firing) * model->per_firing +
                                             static_cast<double>(place) * model->per_laser));
      points.push_back({point_of(range, azimuth, correction), azimuth});
    }
  }
  return true;
}

}  // namespace datasets
