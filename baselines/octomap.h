#pragma once
/// OctoMap: one global octree, the paper's [9] (Hornung et al., Autonomous Robots 2013).
#include <memory>
#include <optional>

#include "ldm/mapper.h"
#include "ldm/parameters.h"

namespace baselines {

/// Inserts each scan as OctoMap does by default, and reads the window around the UAV.
///
/// The leaves are those that octomap::OcTree::insertPointCloud leaves behind (a test), sooner:
/// OctoMap's own steps, with the cells of a scan in a grid instead of two hash sets
/// (ScanCells), and from leaf to leaf instead of from the root (OctreeCursor). Inner nodes get no
/// occupancy, which nothing here reads.
///
/// Rays end at half the diagonal of that window, as OctoMap's own range limit: longer ones, and
/// those without a return (if they count as free), clear the way up to there. The tree covers
/// 65,536 voxels per axis and grows with the space seen; what a UAV finds on its return is what it
/// left.
class Octomap final : public ldm::Mapper {
 public:
  /// Reads `map` and `sensor_model`. @throws ldm::InvalidInput on a parameter out of its range.
  explicit Octomap(const ldm::Parameters& parameters);
  ~Octomap() override;

  /// @throws ldm::InvalidInput also on a UAV or sensor too close to the border of the tree.
  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  /// Cost: a walk over the leaves in the window.
  void read(ldm::LocalMap& map) const override;

 private:
  void check_reach(const char* name, const ldm::Pose& pose) const;

  double resolution_;
  bool use_no_returns_;
  ldm::VoxelBox window_;
  double max_range_;            // [m]
  std::optional<double> time_;  // of the last scan [s]
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace baselines
