#pragma once
/// The Local Dynamic Map: one frame of Fig. 1, paper Sec. 3.
#include <optional>

#include "ldm/cluster_tracker.h"
#include "ldm/cluster_velocity.h"
#include "ldm/clustering.h"
#include "ldm/mapper.h"
#include "ldm/measurement_flags.h"
#include "ldm/occupancy_prediction.h"
#include "ldm/occupancy_update.h"
#include "ldm/parameters.h"
#include "ldm/particles.h"
#include "ldm/ring_buffer.h"

namespace ldm {

class LocalDynamicMap final : public Mapper {
 public:
  /// @throws InvalidInput naming the first parameter out of its range.
  explicit LocalDynamicMap(const Parameters& parameters);

  void update(const Scan& scan, StageListener* listener = nullptr) override;
  void read(LocalMap& map) const override;

  const RingBuffer<float>& log_odds() const { return log_odds_; }
  const Particles& particles() const { return particles_; }

 private:
  void movement_update(const Scan& scan);

  Parameters parameters_;
  std::optional<double> time_;  // of the last scan [s]
  RingBuffer<float> log_odds_;
  MeasurementFlags flags_;
  OccupancyPrediction prediction_;
  OccupancyUpdate occupancy_;
  Particles particles_;
  Clustering clustering_;
  ClusterTracker tracker_;
};

}  // namespace ldm
