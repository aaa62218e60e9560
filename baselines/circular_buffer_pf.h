#pragma once
/// The circular buffer of [11] with the particle filter and the clustering of paper Sec. 3 beside
/// it.
#include <optional>

#include "baselines/circular_buffer.h"
#include "ldm/cluster_tracker.h"
#include "ldm/clustering.h"
#include "ldm/particles.h"

namespace baselines {

/// Velocities as in the LDM, but the map knows nothing of them: what occupancy prediction and
/// survival bring is the difference between this and the LDM.
class CircularBufferPf final : public ldm::Mapper {
 public:
  /// Reads `map`, `sensor_model`, `particles`, `clusters` and `execution`.
  /// @throws ldm::InvalidInput on a parameter out of its range.
  explicit CircularBufferPf(const ldm::Parameters& parameters);

  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  void read(ldm::LocalMap& map) const override;

 private:
  CircularBuffer map_;
  ldm::ClusterParameters cluster_parameters_;
  std::optional<double> time_;  // of the last scan [s]
  ldm::RingIndex index_;        // where the particles are: follows the map's
  ldm::Particles particles_;
  ldm::Clustering clustering_;
  ldm::ClusterTracker tracker_;
};

}  // namespace baselines
