#pragma once
/// Clusters that are groups of a scan's returns, in a map that knows the scan alone.
#include <Eigen/Core>
#include <span>
#include <vector>

#include "ldm/types.h"

namespace baselines {

/// Filled anew for each scan; a voxel belongs to the first group that has a return in it.
class PointClusters {
 public:
  void clear() { groups_.clear(); }
  /// @param object what is known of it: identity, age, velocity
  /// @param points its returns, world [m]
  void add(const ldm::Cluster& object, std::vector<Eigen::Vector3d> points) {
    groups_.push_back({object, std::move(points)});
  }

  /// Clusters, of the occupied voxels that hold their returns, and labels; none of a group outside
  /// of the map. Requires the map's window and occupancy.
  void read(ldm::LocalMap& map) const;

 private:
  struct Group {
    ldm::Cluster object;
    std::vector<Eigen::Vector3d> points;
  };
  std::vector<Group> groups_;
};

}  // namespace baselines
