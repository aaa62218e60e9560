#pragma once
/// Occupancy in a circular buffer: the paper's [11] (Usenko et al., IROS 2017), Sec. III.
#include <optional>

#include "ldm/mapper.h"
#include "ldm/measurement_flags.h"
#include "ldm/occupancy_update.h"
#include "ldm/parameters.h"
#include "ldm/ring_buffer.h"

namespace baselines {

/// Hits and misses accumulate in the voxels around the UAV: nothing moves, nothing fades.
///
/// Each scan changes a voxel once, by the log-odds of a hit or of a crossing ray, within the
/// clamps; a voxel that no ray meets keeps its value while it stays in the window.
class CircularBuffer final : public ldm::Mapper {
 public:
  /// Reads `map` and `sensor_model`. @throws ldm::InvalidInput on a parameter out of its range.
  explicit CircularBuffer(const ldm::Parameters& parameters);

  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  void read(ldm::LocalMap& map) const override;

  const ldm::RingBuffer<float>& log_odds() const { return log_odds_; }

 private:
  double resolution_;
  std::optional<double> time_;  // of the last scan [s]
  ldm::RingBuffer<float> log_odds_;
  ldm::MeasurementFlags flags_;
  ldm::OccupancyUpdate occupancy_;
};

}  // namespace baselines
