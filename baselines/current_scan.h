#pragma once
/// The map without a memory: occupied is what the last scan hit, and nothing else.
#include <optional>

#include "ldm/mapper.h"
#include "ldm/measurement_flags.h"
#include "ldm/parameters.h"

namespace baselines {

/// P is p_occ in a voxel with a return, p_free in one that rays crossed, 0.5 in one that no ray
/// met: all but the hits count as free. The humblest map: any memory must earn its place against
/// it.
class CurrentScan final : public ldm::Mapper {
 public:
  /// Reads `map` and of `sensor_model` p_occ, p_free and no_returns.
  /// @throws ldm::InvalidInput on a parameter out of its range.
  explicit CurrentScan(const ldm::Parameters& parameters);

  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  void read(ldm::LocalMap& map) const override;

 private:
  double resolution_;
  float p_occ_;
  float p_free_;
  std::optional<double> time_;  // of the last scan [s]
  ldm::VoxelBox window_;
  ldm::MeasurementFlags flags_;
};

}  // namespace baselines
