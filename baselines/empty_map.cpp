#include "baselines/empty_map.h"

#include "baselines/no_clusters.h"
#include "ldm/scan_check.h"

namespace baselines {

EmptyMap::EmptyMap(const ldm::Parameters& parameters)
    : resolution_(ldm::checked(parameters).map.resolution),
      window_{-parameters.map.voxels / 2, parameters.map.voxels} {}

void EmptyMap::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  ldm::check_scan(scan, time_);
  time_ = scan.time;

  if (listener != nullptr) listener->begin("movement_update");
  window_.origin = ldm::voxel_at(scan.T_world_uav.translation, resolution_) - window_.size / 2;
}

void EmptyMap::read(ldm::LocalMap& map) const {
  map.window = window_;
  map.resolution = resolution_;
  map.occupancy.assign(window_.count(), ldm::kUnknown);
  read_no_clusters(map);
}

}  // namespace baselines
