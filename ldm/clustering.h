#pragma once
/// Voxel clustering over the 26-neighbourhood: paper Sec. 3.5.
#include <cstdint>
#include <span>
#include <vector>

#include "ldm/parameters.h"
#include "ldm/ring_buffer.h"

namespace ldm {

/// Occupied voxels in a row: [x_begin, x_end) of row (y, z), counted from the window's lowest
/// voxel.
struct Run {
  std::int16_t x_begin;
  std::int16_t x_end;
  std::int16_t y;
  std::int16_t z;
  std::int32_t cluster;  ///< position in Clustering::clusters
};

/// Connected groups of voxels whose probability is above the threshold.
class Clustering {
 public:
  Clustering(const MapParameters& map, const ClusterParameters& clusters);

  /// Find the clusters of `log_odds`: position, size and number of voxels; velocities are zero.
  /// Clusters are numbered by their first voxel in window order. Cost: one pass over the map, plus
  /// the runs of occupied voxels.
  void find(const RingBuffer<float>& log_odds);

  /// Make the clusters of each group one, wherever they are; -1 is no group. Velocities are zero
  /// again.
  /// @param group per cluster; changed to that of the new ones. Cost: n log n in the runs, if any
  /// join
  void join(std::vector<std::int32_t>& group, const VoxelBox& window);

  /// Log-odds above which a voxel is occupied.
  float threshold() const { return threshold_; }
  /// All runs, cluster after cluster, each in window order.
  std::span<const Run> runs() const { return runs_; }
  std::span<const Run> runs_of(std::size_t cluster) const {
    return runs().subspan(first_run_[cluster], first_run_[cluster + 1] - first_run_[cluster]);
  }
  std::vector<Cluster>& clusters() { return clusters_; }
  const std::vector<Cluster>& clusters() const { return clusters_; }

  /// Write labels and clusters into `map`, whose window and resolution are set.
  void read(LocalMap& map) const;

 private:
  bool is_empty(const float* l, int n) const;
  int next_occupied(const float* l, int i, int n) const;
  void find_runs(const RingBuffer<float>& log_odds);
  void add_run(int x_begin, int x_end, int y, int z);
  void connect_rows();
  void connect(std::size_t row, std::size_t row_before);
  std::int32_t root(std::int32_t run);
  void measure(const VoxelBox& window);
  void group_runs();

  double resolution_;
  float threshold_;
  Eigen::Vector3i size_;
  std::vector<Run> runs_;
  std::vector<std::int32_t> first_run_of_row_;  // row y + ny z; one more than rows
  std::vector<std::int32_t> parent_;  // union-find over runs; the smaller number is the root
  std::vector<Cluster> clusters_;
  std::vector<std::size_t> first_run_;  // per cluster, and one more
  std::vector<Run> grouped_;            // memory of group_runs
  struct Extent {
    Eigen::Vector3i low;
    Eigen::Vector3i high;
    Eigen::Matrix<std::int64_t, 3, 1> twice_sum;  // of the voxel centres
  };
  std::vector<Extent> extents_;
};

/// Calls visit(first, n) for each stretch of slots [first, first + n) that `runs` stand in, where
/// `index` is that of the clustering.
template <class Visit>
void for_each_stretch(const RingIndex& index, std::span<const Run> runs, Visit&& visit) {
  for (const Run& run : runs) {
    for (const RowPiece& piece : row_pieces(index, run.x_begin, run.x_end, run.y, run.z)) {
      if (piece.length > 0) visit(piece.slot, static_cast<std::size_t>(piece.length));
    }
  }
}

/// Calls visit(slot) for each of those slots.
template <class Visit>
void for_each_slot(const RingIndex& index, std::span<const Run> runs, Visit&& visit) {
  for_each_stretch(index, runs, [&](std::size_t first, std::size_t n) {
    for (std::size_t slot = first; slot < first + n; ++slot) visit(slot);
  });
}

}  // namespace ldm
