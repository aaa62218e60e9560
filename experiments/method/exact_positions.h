#pragma once
/// The oracle of object velocities: the filter of object_ldm, told where each object is (no paper
/// section; docs/objects.md).
#include <map>
#include <optional>

#include "baselines/current_scan.h"
#include "baselines/point_clusters.h"
#include "experiments/method/sees_truth.h"
#include "ldm/objects/motion_filter.h"

namespace experiments {

/// The map of CurrentScan. A cluster is an object's returns, which is known; its velocity is what
/// ldm::MotionFilter makes of the true centres of the scans in which it had some.
class ExactPositions final : public ldm::Mapper, public SeesTruth {
 public:
  /// Reads what CurrentScan does, and `clusters.static_below_mps`: what is slower is not dynamic.
  /// @throws ldm::InvalidInput on a parameter out of its range.
  explicit ExactPositions(const ldm::Parameters& parameters);

  void see(const datasets::Truth& truth) override { truth_ = truth; }
  /// Without a truth there are no clusters.
  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  void read(ldm::LocalMap& map) const override;

 private:
  struct Followed {
    double since, seen;  // [s]
    ldm::MotionFilter filter;
  };
  void follow(const ldm::Scan& scan);

  baselines::CurrentScan map_;
  double static_below_;
  std::optional<double> time_;  // of the last scan [s]
  std::optional<datasets::Truth> truth_;
  std::map<std::int32_t, Followed> followed_;  // by the object's number
  baselines::PointClusters clusters_;
};

}  // namespace experiments
