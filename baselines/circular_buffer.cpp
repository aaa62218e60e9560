#include "baselines/circular_buffer.h"

#include "baselines/no_clusters.h"
#include "ldm/read_occupancy.h"
#include "ldm/scan_check.h"

namespace baselines {
namespace {

constexpr bool kShadows = false;
constexpr ldm::SurvivalParameters kNothingFades{.enabled = false};

}  // namespace

CircularBuffer::CircularBuffer(const ldm::Parameters& parameters)
    : resolution_(ldm::checked(parameters).map.resolution),
      log_odds_(parameters.map.voxels, 0.0F),
      flags_(parameters.map, parameters.sensor_model.no_returns, kShadows),
      occupancy_(parameters.map, parameters.sensor_model, kNothingFades) {}

void CircularBuffer::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  const auto stage = [listener](std::string_view name) {
    if (listener != nullptr) listener->begin(name);
  };
  ldm::check_scan(scan, time_);
  time_ = scan.time;

  stage("movement_update");
  log_odds_.recenter(ldm::voxel_at(scan.T_world_uav.translation, resolution_));
  stage("measurement_flags");
  flags_.mark(scan, log_odds_.index().window());
  stage("occupancy_update");
  occupancy_.apply(flags_.flags(), {}, log_odds_);
}

void CircularBuffer::read(ldm::LocalMap& map) const {
  ldm::read_occupancy(log_odds_, resolution_, map);
  read_no_clusters(map);
}

}  // namespace baselines
