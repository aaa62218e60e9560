#include "baselines/current_scan.h"

#include "baselines/no_clusters.h"
#include "ldm/scan_check.h"

namespace baselines {
namespace {

constexpr bool kShadows = false;

}  // namespace

CurrentScan::CurrentScan(const ldm::Parameters& parameters)
    : resolution_(ldm::checked(parameters).map.resolution),
      p_occ_(static_cast<float>(parameters.sensor_model.p_occ)),
      p_free_(static_cast<float>(parameters.sensor_model.p_free)),
      window_{-parameters.map.voxels / 2, parameters.map.voxels},
      flags_(parameters.map, parameters.sensor_model.no_returns, kShadows) {}

void CurrentScan::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  ldm::check_scan(scan, time_);
  time_ = scan.time;

  if (listener != nullptr) listener->begin("measurement_flags");
  window_.origin = ldm::voxel_at(scan.T_world_uav.translation, resolution_) - window_.size / 2;
  flags_.mark(scan, window_);
}

void CurrentScan::read(ldm::LocalMap& map) const {
  map.window = window_;
  map.resolution = resolution_;
  map.occupancy.clear();
  for (const std::uint8_t f : flags_.flags()) {
    map.occupancy.push_back(f == ldm::flag::kOccupied ? p_occ_
                            : f == ldm::flag::kFree   ? p_free_
                                                      : ldm::kUnknown);
  }
  read_no_clusters(map);
}

}  // namespace baselines
