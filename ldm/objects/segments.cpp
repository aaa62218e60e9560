#include "ldm/objects/segments.h"

#include <algorithm>

namespace ldm {
void Segments::find(std::span<const Eigen::Vector3d> points) {
  fill_cells(points);
  connect_cells();
  group(points.size());
}

void Segments::fill_cells(std::span<const Eigen::Vector3d> points) {
  cells_.clear();
  parent_.clear();
  cell_of_.clear();
  if (points.empty()) return;
  VoxelIndex low = voxel_at(points[0], edge_), high = low;
  for (const Eigen::Vector3d& p : points) {
    low = low.cwiseMin(voxel_at(p, edge_));
    high = high.cwiseMax(voxel_at(p, edge_));
  }
  box_.origin = low - reach_;
  box_.size = high + reach_ - box_.origin + VoxelIndex::Ones();
  cell_at_.assign(box_.count(), -1);
  for (const Eigen::Vector3d& p : points) {
    const VoxelIndex v = voxel_at(p, edge_);
    std::int32_t& cell = cell_at_[box_.index(v)];
    if (cell < 0) {
      cell = static_cast<std::int32_t>(cells_.size());
      parent_.push_back(cells_.size());
      cells_.push_back(v);
    }
    cell_of_.push_back(static_cast<std::size_t>(cell));
  }
}

std::size_t Segments::root(std::size_t cell) {
  while (parent_[cell] != cell) cell = parent_[cell] = parent_[parent_[cell]];
  return cell;
}

void Segments::connect_cells() {
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const VoxelIndex low = cells_[c] - reach_, high = cells_[c] + reach_;
    for (VoxelIndex v = low; v.z() <= high.z(); ++v.z()) {
      for (v.y() = low.y(); v.y() <= high.y(); ++v.y()) {
        for (v.x() = low.x(); v.x() <= high.x(); ++v.x()) {
          const std::int32_t other = cell_at_[box_.index(v)];
          if (other < 0) continue;
          const std::size_t a = root(c), b = root(static_cast<std::size_t>(other));
          parent_[std::max(a, b)] = std::min(a, b);
        }
      }
    }
  }
}

void Segments::group(std::size_t points) {
  std::vector<std::size_t> segment_of(cells_.size());
  std::size_t count = 0;
  // A root comes before the other cells of its segment.
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    segment_of[c] = root(c) == c ? count++ : segment_of[root(c)];
  }
  first_.assign(count + 1, 0);
  for (const std::size_t cell : cell_of_) ++first_[segment_of[cell] + 1];
  for (std::size_t s = 0; s < count; ++s) first_[s + 1] += first_[s];
  std::vector<std::size_t> end(first_.begin(), first_.end() - 1);
  members_.resize(points);
  for (std::size_t i = 0; i < points; ++i) members_[end[segment_of[cell_of_[i]]]++] = i;
}

}  // namespace ldm
