#pragma once
/// The map that knows nothing: every voxel is unknown, whatever is scanned.
#include <optional>

#include "ldm/mapper.h"
#include "ldm/parameters.h"

namespace baselines {

/// P is 0.5 everywhere. Not a competitor but a check of the scores: one that this map wins does not
/// tell a good map from none.
class EmptyMap final : public ldm::Mapper {
 public:
  /// Reads `map`.
  /// @throws ldm::InvalidInput on a parameter out of its range.
  explicit EmptyMap(const ldm::Parameters& parameters);

  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  void read(ldm::LocalMap& map) const override;

 private:
  double resolution_;
  std::optional<double> time_;  // of the last scan [s]
  ldm::VoxelBox window_;
};

}  // namespace baselines
