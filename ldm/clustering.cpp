#include "ldm/clustering.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "ldm/log_odds.h"

namespace ldm {

Clustering::Clustering(const MapParameters& map, const ClusterParameters& clusters)
    : resolution_(map.resolution),
      threshold_(static_cast<float>(log_odds(clusters.occupied_above))),
      size_(map.voxels) {
  // Room for what is usual; a map with more of it takes more once.
  constexpr std::size_t kUsualClusters = 256;
  constexpr std::size_t kUsualRuns = 4096;
  for (auto* const runs : {&runs_, &grouped_}) runs->reserve(kUsualRuns);
  parent_.reserve(kUsualRuns);
  clusters_.reserve(kUsualClusters);
  first_run_.reserve(kUsualClusters + 1);
  extents_.reserve(kUsualClusters);
  first_run_of_row_.reserve(
      static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(size_.z()) + 1);
}

void Clustering::find(const RingBuffer<float>& log_odds) {
  find_runs(log_odds);
  connect_rows();
  measure(log_odds.index().window());
  group_runs();
}

void Clustering::join(std::vector<std::int32_t>& group, const VoxelBox& window) {
  // The first cluster of each group, or else the cluster itself.
  std::map<std::int32_t, std::int32_t> first_of;
  std::vector<std::int32_t> target(group.size());
  bool any = false;
  for (std::size_t c = 0; c < group.size(); ++c) {
    const auto own = static_cast<std::int32_t>(c);
    target[c] = group[c] < 0 ? own : first_of.try_emplace(group[c], own).first->second;
    any |= target[c] != own;
  }
  if (!any) return;
  const auto place = [](const Run& run) { return std::tuple(run.z, run.y, run.x_begin); };
  std::sort(runs_.begin(), runs_.end(),
            [&](const Run& a, const Run& b) { return place(a) < place(b); });
  std::vector<std::int32_t> root_of(group.size(), -1), groups;
  parent_.clear();
  for (const Run& run : runs_) {
    const auto cluster = static_cast<std::size_t>(run.cluster);
    std::int32_t& root = root_of[static_cast<std::size_t>(target[cluster])];
    if (root < 0) {
      root = static_cast<std::int32_t>(parent_.size());
      groups.push_back(group[cluster]);
    }
    parent_.push_back(root);
  }
  measure(window);
  group_runs();
  group = std::move(groups);
}

void Clustering::add_run(int x_begin, int x_end, int y, int z) {
  const auto row_start = static_cast<std::size_t>(first_run_of_row_.back());
  // A run that goes on across the wrap of its row was begun by the piece before.
  if (runs_.size() > row_start && runs_.back().x_end == x_begin) {
    runs_.back().x_end = static_cast<std::int16_t>(x_end);
    return;
  }
  runs_.push_back({static_cast<std::int16_t>(x_begin), static_cast<std::int16_t>(x_end),
                   static_cast<std::int16_t>(y), static_cast<std::int16_t>(z), 0});
}

/// Looks at all of them, in vectors.
bool Clustering::is_empty(const float* l, int n) const {
  int any = 0;
  for (int k = 0; k < n; ++k) any |= static_cast<int>(l[k] > threshold_);
  return any == 0;
}

/// The first occupied voxel from i on, or n.
int Clustering::next_occupied(const float* l, int i, int n) const {
  constexpr int kStretch = 16;
  while (i + kStretch <= n && is_empty(l + i, kStretch)) i += kStretch;
  while (i < n && !(l[i] > threshold_)) ++i;
  return i;
}

void Clustering::find_runs(const RingBuffer<float>& log_odds) {
  const float* const cells = log_odds.cells().data();
  runs_.clear();
  first_run_of_row_.clear();
  for (int z = 0; z < size_.z(); ++z) {
    for (int y = 0; y < size_.y(); ++y) {
      first_run_of_row_.push_back(static_cast<std::int32_t>(runs_.size()));
      // Most rows are empty. A row as a whole has its slots side by side, wherever it wraps.
      const std::size_t row = row_slot(log_odds.index(), y, z);
      if (!log_odds.may_exceed(threshold_, row, static_cast<std::size_t>(size_.x()))) continue;
      for (const RowPiece& piece : row_pieces(log_odds.index(), 0, size_.x(), y, z)) {
        const float* const l = cells + piece.slot;
        for (int i = next_occupied(l, 0, piece.length); i < piece.length;) {
          const int begin = i;
          while (i < piece.length && l[i] > threshold_) ++i;
          add_run(piece.x + begin, piece.x + i, y, z);
          i = next_occupied(l, i, piece.length);
        }
      }
    }
  }
  first_run_of_row_.push_back(static_cast<std::int32_t>(runs_.size()));
}

std::int32_t Clustering::root(std::int32_t run) {
  auto& parent = parent_;
  const auto up = [&](std::int32_t r) -> std::int32_t& {
    return parent[static_cast<std::size_t>(r)];
  };
  while (up(run) != run) run = up(run) = up(up(run));  // halves the path on the way
  return run;
}

/// Joins the runs of two neighbouring rows that touch, corners included.
void Clustering::connect(std::size_t row, std::size_t row_before) {
  std::int32_t a = first_run_of_row_[row];
  std::int32_t b = first_run_of_row_[row_before];
  const std::int32_t a_end = first_run_of_row_[row + 1];
  const std::int32_t b_end = first_run_of_row_[row_before + 1];
  while (a < a_end && b < b_end) {
    const Run& run = runs_[static_cast<std::size_t>(a)];
    const Run& before = runs_[static_cast<std::size_t>(b)];
    if (run.x_begin <= before.x_end && before.x_begin <= run.x_end) {
      const std::int32_t i = root(a);
      const std::int32_t j = root(b);
      parent_[static_cast<std::size_t>(std::max(i, j))] = std::min(i, j);
    }
    (run.x_end < before.x_end ? a : b)++;
  }
}

void Clustering::connect_rows() {
  parent_.resize(runs_.size());
  for (std::size_t i = 0; i < runs_.size(); ++i) parent_[i] = static_cast<std::int32_t>(i);
  const auto ny = static_cast<std::size_t>(size_.y());
  const std::size_t rows = first_run_of_row_.size() - 1;
  for (std::size_t row = 0; row < rows; ++row) {
    if (first_run_of_row_[row] == first_run_of_row_[row + 1]) continue;
    const std::size_t y = row % ny;
    if (y > 0) connect(row, row - 1);
    if (row < ny) continue;  // lowest layer
    if (y > 0) connect(row, row - ny - 1);
    connect(row, row - ny);
    if (y + 1 < ny) connect(row, row - ny + 1);
  }
}

/// Numbers the clusters and takes their mean, extent and number of voxels.
void Clustering::measure(const VoxelBox& window) {
  clusters_.clear();
  extents_.clear();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    Run& run = runs_[i];
    const auto r = static_cast<std::size_t>(root(static_cast<std::int32_t>(i)));
    if (r == i) {
      run.cluster = static_cast<std::int32_t>(clusters_.size());
      clusters_.emplace_back();
      extents_.push_back({Eigen::Vector3i::Constant(RingIndex::kMostVoxels),
                          Eigen::Vector3i::Zero(), Eigen::Matrix<std::int64_t, 3, 1>::Zero()});
    } else {
      run.cluster = runs_[r].cluster;  // the root comes first: it is numbered
    }
    const auto c = static_cast<std::size_t>(run.cluster);
    const int n = run.x_end - run.x_begin;
    extents_[c].low = extents_[c].low.cwiseMin(Eigen::Vector3i(run.x_begin, run.y, run.z));
    extents_[c].high = extents_[c].high.cwiseMax(Eigen::Vector3i(run.x_end, run.y + 1, run.z + 1));
    extents_[c].twice_sum += Eigen::Matrix<std::int64_t, 3, 1>(
        (run.x_begin + run.x_end) * n, (2 * run.y + 1) * n, (2 * run.z + 1) * n);
    clusters_[c].voxels += n;
  }
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    const Extent& extent = extents_[c];
    const Eigen::Vector3d mean = extent.twice_sum.cast<double>() / (2.0 * clusters_[c].voxels) +
                                 window.origin.cast<double>();
    clusters_[c].position = (mean * resolution_).cast<float>();
    clusters_[c].size = ((extent.high - extent.low).cast<double>() * resolution_).cast<float>();
  }
}

/// Brings the runs of each cluster together: a counting sort.
void Clustering::group_runs() {
  first_run_.assign(clusters_.size() + 1, 0);
  for (const Run& run : runs_) ++first_run_[static_cast<std::size_t>(run.cluster) + 1];
  for (std::size_t c = 1; c < first_run_.size(); ++c) first_run_[c] += first_run_[c - 1];
  grouped_.resize(runs_.size());
  for (const Run& run : runs_) grouped_[first_run_[static_cast<std::size_t>(run.cluster)]++] = run;
  std::swap(runs_, grouped_);
  // Each start was carried to its end: shift them back.
  std::copy_backward(first_run_.begin(), first_run_.end() - 1, first_run_.end());
  first_run_.front() = 0;
}

void Clustering::read(LocalMap& map) const {
  map.clusters.reserve(clusters_.capacity());
  map.clusters = clusters_;
  map.labels.assign(map.window.count(), -1);
  for (const Run& run : runs_) {
    const std::size_t first =
        map.window.index(map.window.origin + VoxelIndex(run.x_begin, run.y, run.z));
    std::fill_n(map.labels.begin() + static_cast<std::ptrdiff_t>(first), run.x_end - run.x_begin,
                run.cluster);
  }
}

}  // namespace ldm
