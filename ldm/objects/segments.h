#pragma once
/// Returns that hang together (no paper section; docs/objects.md).
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "ldm/types.h"

namespace ldm {

/// Groups of returns whose cells touch: cubes, and unless told otherwise one may be empty between
/// two above one another, as the rings of a LiDAR are farther apart than its columns.
class Segments {
 public:
  /// @param edge of a cell [m]
  /// @param reach of a cell to those it touches, along x, y, z [cells]
  explicit Segments(double edge, const VoxelIndex& reach = {1, 1, 2})
      : edge_(edge), reach_(reach) {}

  /// Group `points` (world [m]). Cost: the points, and the cells of the box around them.
  void find(std::span<const Eigen::Vector3d> points);

  /// Of the last `find`, by their first point.
  std::size_t count() const { return first_.size() - 1; }
  /// Positions of a segment's points in the list that was given, in its order.
  std::span<const std::size_t> members(std::size_t segment) const {
    return std::span(members_).subspan(first_[segment], first_[segment + 1] - first_[segment]);
  }

 private:
  void fill_cells(std::span<const Eigen::Vector3d> points);
  void connect_cells();
  void group(std::size_t points);
  std::size_t root(std::size_t cell);

  double edge_;
  VoxelIndex reach_;
  VoxelBox box_;                       // of cells, a margin included
  std::vector<std::int32_t> cell_at_;  // per place in the box its occupied cell, or -1
  std::vector<VoxelIndex> cells_;      // occupied ones
  std::vector<std::size_t> parent_;    // union-find over cells; the smaller number is the root
  std::vector<std::size_t> cell_of_;   // per point
  std::vector<std::size_t> first_{0};  // per segment in `members_`, and one more
  std::vector<std::size_t> members_;
};

}  // namespace ldm
