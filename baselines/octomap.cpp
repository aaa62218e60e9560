#include "baselines/octomap.h"

#include <octomap/OcTree.h>

#include <cmath>
#include <sstream>

#include "baselines/no_clusters.h"
#include "baselines/octomap_keys.h"
#include "baselines/octree_cursor.h"
#include "baselines/scan_cells.h"
#include "ldm/log_odds.h"
#include "ldm/scan_check.h"

namespace baselines {
namespace {

octomap::point3d to_octomap(const Eigen::Vector3d& p) {
  const Eigen::Vector3f f = p.cast<float>();
  return {f.x(), f.y(), f.z()};
}

}  // namespace

/// The octree, and its cells that a scan meets.
struct Octomap::Tree {
  Tree(double resolution, double range_limit, const ldm::SensorModelParameters& sensor)
      : max_range(range_limit),
        octree(resolution),
        // Rounding may carry the end of a ray into the next cell.
        cells(octree, static_cast<int>(std::ceil(range_limit / resolution)) + 2) {
    octree.setProbHit(sensor.p_occ);
    octree.setProbMiss(sensor.p_free);
    octree.setClampingThresMin(ldm::probability(sensor.log_odds_min));
    octree.setClampingThresMax(ldm::probability(sensor.log_odds_max));
  }

  /// A ray that ends beyond the range limit clears the way up to it, and marks nothing occupied.
  void cast(const octomap::point3d& sensor, const octomap::point3d& end) {
    const octomap::point3d way = end - sensor;
    if (way.norm() <= max_range) {
      cells.cross(end);
      cells.hit(end);
    } else {
      cells.cross(sensor + way.normalized() * static_cast<float>(max_range));
    }
  }

  /// Inner nodes get no occupancy of their own: nothing here reads it.
  void update() {
    cells.take([this](const octomap::OcTreeKey& key, bool is_hit) {
      octree.updateNodeLogOdds(&cursor.leaf(key),
                               is_hit ? octree.getProbHitLog() : octree.getProbMissLog());
    });
  }

  double max_range;  // [m]
  octomap::OcTree octree;
  OctreeCursor cursor{octree};
  ScanCells cells;
};

Octomap::Octomap(const ldm::Parameters& parameters)
    : resolution_(ldm::checked(parameters).map.resolution),
      use_no_returns_(parameters.sensor_model.no_returns == ldm::NoReturnRays::kFree),
      window_{-parameters.map.voxels / 2, parameters.map.voxels},
      max_range_(parameters.map.voxels.cast<double>().norm() / 2 * resolution_),
      tree_(std::make_unique<Tree>(resolution_, max_range_, parameters.sensor_model)) {}

Octomap::~Octomap() = default;

void Octomap::check_reach(const char* name, const ldm::Pose& pose) const {
  const double reach = kVoxelsToBorder * resolution_ - 2 * max_range_;
  if ((pose.translation.array().abs() <= reach).all()) return;
  std::ostringstream message;
  message << "scan." << name << ": translation (" << pose.translation.transpose()
          << ") m: out of the octree; allowed: coordinates within +-" << reach << " m";
  throw ldm::InvalidInput(message.str());
}

void Octomap::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  ldm::check_scan(scan, time_);
  check_reach("T_world_uav", scan.T_world_uav);
  check_reach("T_world_sensor", scan.T_world_sensor);
  time_ = scan.time;

  if (listener != nullptr) listener->begin("occupancy_update");
  window_.origin = ldm::voxel_at(scan.T_world_uav.translation, resolution_) - window_.size / 2;
  const octomap::point3d sensor = to_octomap(scan.T_world_sensor.translation);
  tree_->cells.start(sensor);
  for (const ldm::Point& p : scan.points) {
    tree_->cast(sensor, to_octomap(scan.T_world_sensor * p.cast<double>()));
  }
  if (use_no_returns_) {
    for (const ldm::Point& direction : scan.no_returns) {
      const Eigen::Vector3d beyond = 2 * max_range_ * direction.cast<double>();
      tree_->cast(sensor, to_octomap(scan.T_world_sensor * beyond));
    }
  }
  tree_->update();
}

void Octomap::read(ldm::LocalMap& map) const {
  map.window = window_;
  map.resolution = resolution_;
  map.occupancy.assign(window_.count(), ldm::kUnknown);
  const ldm::VoxelIndex last = window_.origin + window_.size - ldm::VoxelIndex::Ones();
  const auto end = tree_->octree.end_leafs_bbx();
  for (auto leaf = tree_->octree.begin_leafs_bbx(key_of(window_.origin), key_of(last)); leaf != end;
       ++leaf) {
    // Nobody prunes the tree: each leaf is one voxel.
    map.occupancy[window_.index(voxel_of(leaf.getKey()))] =
        static_cast<float>(leaf->getOccupancy());
  }
  read_no_clusters(map);
}

}  // namespace baselines
