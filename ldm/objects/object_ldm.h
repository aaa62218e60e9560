#pragma once
/// The variant `object_ldm`: the map of paper Sec. 3 whose velocities come from followed objects
/// instead of particles (docs/objects.md).
#include <cstdint>
#include <optional>
#include <vector>

#include "ldm/clustering.h"
#include "ldm/mapper.h"
#include "ldm/measurement_flags.h"
#include "ldm/objects/object_tracker.h"
#include "ldm/occupancy_prediction.h"
#include "ldm/occupancy_update.h"
#include "ldm/parameters.h"
#include "ldm/ring_buffer.h"

namespace ldm {

/// Objects are followed by their returns, also beyond the map, so that no object is cut off at its
/// border and none is too fast to be seen; the map is predicted with their velocities.
class ObjectLdm final : public Mapper {
 public:
  /// Reads `map`, `sensor_model`, `survival`, `prediction` and `clusters.occupied_above`.
  /// @throws InvalidInput naming the first parameter out of its range.
  explicit ObjectLdm(const Parameters& parameters, const Ingredients& ingredients = {});

  void update(const Scan& scan, StageListener* listener = nullptr) override;
  void read(LocalMap& map) const override;

  const std::vector<TrackedObject>& objects() const { return tracker_.objects(); }

 private:
  void track(const Scan& scan);
  void occupy_seen();
  std::vector<std::int32_t> object_of_clusters();
  void set_clusters();

  Parameters parameters_;
  Ingredients ingredients_;
  std::optional<double> time_;  // of the last scan [s]
  RingBuffer<float> log_odds_;
  MeasurementFlags flags_;
  OccupancyPrediction prediction_;
  OccupancyUpdate occupancy_;
  Clustering clustering_;
  ObjectTracker tracker_;
  std::vector<Eigen::Vector3d> points_;   // returns in and around the map, world [m]
  std::vector<std::int32_t> cluster_at_;  // per slot, or -1
};

}  // namespace ldm
