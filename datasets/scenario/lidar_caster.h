#pragma once
/// Casts the LiDAR's rays against the obstacles (the simulated sensor of paper Sec. 4.1.1).
#include <cstdint>
#include <vector>

#include "datasets/frame.h"
#include "datasets/scenario/lidar.h"

namespace datasets {

/// Which rays of a scan can meet a solid: channels [channel_begin, channel_end), and the firings
/// from `firing_begin` on, `firings` of them, counted around the circle.
struct RayWindow {
  std::size_t channel_begin = 0, channel_end = 0;
  std::size_t firing_begin = 0, firings = 0;
};

class LidarCaster {
 public:
  /// @throws ldm::InvalidInput on a model without channels or azimuths, with channels that do not
  /// ascend, or with ranges that 65535 quanta cannot hold.
  explicit LidarCaster(const LidarModel& model);

  /// Fill `image`, and `noise_free_hits` (world frame) with where the rays that return met a solid.
  /// Surfaces are seen from outside alone. The noise of a ray depends on `noise_key` and its
  /// number: give each scan its own key. Cost: 0.2 ms for 20 obstacles at 16 x 1024 rays.
  void cast(const ldm::Pose& T_world_sensor, const std::vector<ObjectState>& objects,
            std::uint64_t noise_key, RangeImage& image, std::vector<ldm::Point>& noise_free_hits);

  /// The rays that can meet the solid; a few more than do, never fewer.
  RayWindow window(const ldm::Pose& T_world_sensor, const Solid& solid) const;

  const LidarModel& model() const { return model_; }
  const BeamTable& beams() const { return beams_; }

 private:
  void cast_solid(const ldm::Pose& T_world_sensor, const Solid& solid);
  template <class Entry>
  void cast_window(const RayWindow& window, const ldm::Pose& T_solid_sensor, Entry entry);

  LidarModel model_;
  BeamTable beams_;
  std::vector<double> nearest_;  ///< distance of the nearest hit of each ray [m], or infinity
};

}  // namespace datasets
