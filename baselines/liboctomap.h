#pragma once
/// OctoMap as its users call it: what Octomap (baselines/octomap.h) must equal, and what its speed
/// is measured by. Needs liboctomap.
#include <octomap/OcTree.h>
#include <octomap/Pointcloud.h>

#include "ldm/log_odds.h"
#include "ldm/mapper.h"
#include "ldm/parameters.h"

namespace baselines {

/// Each scan in one call of insertPointCloud, with its defaults, rays limited to half the diagonal
/// of the window; those without a return are points beyond that limit.
class LibOctomap final : public ldm::Mapper {
 public:
  explicit LibOctomap(const ldm::Parameters& parameters)
      : size_(parameters.map.voxels),
        max_range_(size_.cast<double>().norm() / 2 * parameters.map.resolution),
        tree_(parameters.map.resolution) {
    const ldm::SensorModelParameters& sensor = parameters.sensor_model;
    tree_.setProbHit(sensor.p_occ);
    tree_.setProbMiss(sensor.p_free);
    tree_.setClampingThresMin(ldm::probability(sensor.log_odds_min));
    tree_.setClampingThresMax(ldm::probability(sensor.log_odds_max));
  }

  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override {
    if (listener != nullptr) listener->begin("occupancy_update");
    window_ = {ldm::voxel_at(scan.T_world_uav.translation, tree_.getResolution()) - size_ / 2,
               size_};
    octomap::Pointcloud cloud;
    cloud.reserve(scan.points.size() + scan.no_returns.size());
    for (const ldm::Point& p : scan.points) {
      cloud.push_back(to_octomap(scan.T_world_sensor * p.cast<double>()));
    }
    for (const ldm::Point& direction : scan.no_returns) {
      const Eigen::Vector3d beyond = 2 * max_range_ * direction.cast<double>();
      cloud.push_back(to_octomap(scan.T_world_sensor * beyond));
    }
    tree_.insertPointCloud(cloud, to_octomap(scan.T_world_sensor.translation), max_range_);
  }

  /// Voxel by voxel: a search from the root for each.
  void read(ldm::LocalMap& map) const override {
    map.window = window_;
    map.resolution = tree_.getResolution();
    map.occupancy.clear();
    for_each_voxel(window_, [&](const ldm::VoxelIndex& v, std::size_t) {
      const Eigen::Vector3d middle = (v.cast<double>().array() + 0.5) * tree_.getResolution();
      const octomap::OcTreeNode* const leaf = tree_.search(to_octomap(middle));
      map.occupancy.push_back(leaf == nullptr ? ldm::kUnknown
                                              : static_cast<float>(leaf->getOccupancy()));
    });
  }

 private:
  static octomap::point3d to_octomap(const Eigen::Vector3d& p) {
    const Eigen::Vector3f f = p.cast<float>();
    return {f.x(), f.y(), f.z()};
  }

  Eigen::Vector3i size_;
  double max_range_;  // [m]
  octomap::OcTree tree_;
  ldm::VoxelBox window_;
};

}  // namespace baselines
