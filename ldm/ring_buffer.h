#pragma once
/// Circular voxel buffer: paper Sec. 3.3.1, Eq. (6), Fig. 4; idea of Usenko et al., IROS 2017.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "ldm/machine/bricks.h"
#include "ldm/types.h"

namespace ldm {

/// Where the voxels of a moving window live: voxel v in slot v mod n, per axis, x fastest.
/// A voxel that stays in the window keeps its slot, so moving the window copies nothing.
class RingIndex {
 public:
  static constexpr int kMostVoxels = 512;  ///< along an axis

  /// n voxels per axis; the window starts centred on voxel 0. @throws InvalidInput unless each is
  /// in 5..kMostVoxels.
  explicit RingIndex(const Eigen::Vector3i& n);

  const VoxelBox& window() const { return window_; }
  std::size_t count() const { return window_.count(); }
  /// Voxel of the window in which the UAV is: the centre, floor(n / 2) from the origin per axis.
  VoxelIndex centre() const { return window_.origin + window_.size / 2; }
  /// Slot of the window's lowest voxel, per axis: origin mod n.
  const Eigen::Vector3i& origin_slot() const { return origin_slot_; }
  /// The paper's o: which voxel, counted from the window's lowest, lies in slot 0.
  Eigen::Vector3i offset() const;

  /// Slot of `local`, a voxel counted from the window's lowest; requires 0 <= local < n.
  std::size_t slot_of_local(int x, int y, int z) const {
    return wrapped(x, 0) +
           static_cast<std::size_t>(window_.size.x()) *
               (wrapped(y, 1) + static_cast<std::size_t>(window_.size.y()) * wrapped(z, 2));
  }
  /// Slot of world voxel v; requires window().contains(v).
  std::size_t slot(const VoxelIndex& v) const {
    const VoxelIndex d = v - window_.origin;
    return slot_of_local(d.x(), d.y(), d.z());
  }

  /// Move the window so that its centre voxel is c: o_k = o_{k-1} - (X_k - X_{k-1}), modulo n.
  /// Calls entered(first_slot, n_slots) for each stretch of slots whose voxel is new.
  /// Cost: the voxels that enter.  Eq. (6)
  template <class Entered>
  void recenter(const VoxelIndex& c, Entered&& entered);

 private:
  std::size_t wrapped(int local, int axis) const {
    const int s = local + origin_slot_[axis];
    return static_cast<std::size_t>(s < window_.size[axis] ? s : s - window_.size[axis]);
  }
  void place(const VoxelIndex& origin);

  VoxelBox window_;
  Eigen::Vector3i origin_slot_;
};

/// One cell a voxel, in the slots of a RingIndex; cells whose voxel is new become `empty`. Of each
/// brick of them (bricks.h) a range is known that holds all its cells.
template <class Cell>
class RingBuffer {
 public:
  explicit RingBuffer(const Eigen::Vector3i& n, Cell empty = {})
      : index_(n),
        empty_(empty),
        cells_(index_.count(), empty),
        ranges_(bricks_of(index_.count()), {empty, empty}) {}

  const RingIndex& index() const { return index_; }
  /// All cells, in slot order. To be written, they may become anything.
  std::span<Cell> cells() {
    std::fill(ranges_.begin(), ranges_.end(), Range<Cell>::all());
    return cells_;
  }
  std::span<const Cell> cells() const { return cells_; }
  /// The cell in a slot. To be written, it may become anything.
  Cell& in_slot(std::size_t slot) {
    ranges_[slot / kBrick] = Range<Cell>::all();
    return cells_[slot];
  }
  /// The cell of world voxel v; requires index().window().contains(v).
  Cell& at(const VoxelIndex& v) { return in_slot(index_.slot(v)); }
  const Cell& at(const VoxelIndex& v) const { return cells_[index_.slot(v)]; }

  /// What is known of the cells of a brick.
  const Range<Cell>& range(std::size_t brick) const { return ranges_[brick]; }
  /// True if cells in slots [first, first + n), n > 0, may be above `value`. Cost: the bricks.
  bool may_exceed(Cell value, std::size_t first, std::size_t n) const {
    const auto begin = ranges_.begin() + static_cast<std::ptrdiff_t>(first / kBrick);
    const auto end = ranges_.begin() + static_cast<std::ptrdiff_t>((first + n - 1) / kBrick + 1);
    return std::any_of(begin, end, [&](const Range<Cell>& range) { return range.high > value; });
  }
  /// For a pass that changes cells and says of each brick anew what it holds: all cells, and all
  /// ranges beside them.
  struct Contents {
    std::span<Cell> cells;
    std::span<Range<Cell>> ranges;
  };
  Contents contents() { return {cells_, ranges_}; }

  /// See RingIndex::recenter; `entered` is called after the cells were emptied.
  template <class Entered>
  void recenter(const VoxelIndex& c, Entered&& entered) {
    index_.recenter(c, [&](std::size_t first, std::size_t n) {
      std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(first), n, empty_);
      for (std::size_t brick = first / kBrick; brick * kBrick < first + n; ++brick) {
        ranges_[brick].include({empty_, empty_});
      }
      entered(first, n);
    });
  }
  void recenter(const VoxelIndex& c) {
    recenter(c, [](std::size_t, std::size_t) {});
  }

 private:
  RingIndex index_;
  Cell empty_;
  std::vector<Cell> cells_;
  std::vector<Range<Cell>> ranges_;  // per brick
};

/// The lowest slot of row (y, z), counted from the window's lowest voxel: its others follow.
inline std::size_t row_slot(const RingIndex& index, int y, int z) {
  return index.slot_of_local(0, y, z) - static_cast<std::size_t>(index.origin_slot().x());
}

/// A stretch of a window row along x and the slots it lives in: a row wraps at most once.
struct RowPiece {
  int x;             ///< first voxel, counted from the window's lowest
  int length;        ///< voxels
  std::size_t slot;  ///< slot of the first; the others follow
};
/// The pieces of voxels [x_begin, x_end) of row (y, z), both counted from the window's lowest
/// voxel. The second piece may be empty.
inline std::array<RowPiece, 2> row_pieces(const RingIndex& index, int x_begin, int x_end, int y,
                                          int z) {
  const int wrap = index.window().size.x() - index.origin_slot().x();  // first x in slot 0
  const int cut = std::clamp(wrap, x_begin, x_end);
  const std::size_t row = row_slot(index, y, z);
  return {RowPiece{x_begin, cut - x_begin,
                   row + static_cast<std::size_t>(x_begin + index.origin_slot().x())},
          RowPiece{cut, x_end - cut, row + static_cast<std::size_t>(cut - wrap)}};
}

// ------------------------------------------------------------------------------------------------

inline RingIndex::RingIndex(const Eigen::Vector3i& n) {
  for (int axis = 0; axis < 3; ++axis) {
    if (n[axis] < 5 || n[axis] > kMostVoxels) {
      throw InvalidInput("map.voxels[" + std::to_string(axis) + "] = " + std::to_string(n[axis]) +
                         ": allowed: 5 to " + std::to_string(kMostVoxels));
    }
  }
  window_.size = n;
  place(-n / 2);
}

inline void RingIndex::place(const VoxelIndex& origin) {
  window_.origin = origin;
  for (int axis = 0; axis < 3; ++axis) {
    const int n = window_.size[axis];
    origin_slot_[axis] = ((origin[axis] % n) + n) % n;
  }
}

inline Eigen::Vector3i RingIndex::offset() const {
  Eigen::Vector3i o;
  for (int axis = 0; axis < 3; ++axis) {
    o[axis] = origin_slot_[axis] == 0 ? 0 : window_.size[axis] - origin_slot_[axis];
  }
  return o;
}

template <class Entered>
void RingIndex::recenter(const VoxelIndex& c, Entered&& entered) {
  const Eigen::Vector3i move = c - centre();
  const Eigen::Vector3i n = window_.size;
  if (move.isZero()) return;
  place(window_.origin + move);
  if ((move.array().abs() >= n.array()).any()) {
    entered(std::size_t{0}, count());
    return;
  }
  // Per axis the new voxels are the last `move` ones, or the first -move ones.
  const Eigen::Vector3i first = (move.array() > 0).select(n - move, 0);
  const Eigen::Vector3i last = (move.array() > 0).select(n, -move);
  for (int z = 0; z < n.z(); ++z) {
    const bool whole_layer = z >= first.z() && z < last.z();
    for (int y = 0; y < n.y(); ++y) {
      const bool whole_row = whole_layer || (y >= first.y() && y < last.y());
      if (!whole_row && move.x() == 0) continue;
      for (const RowPiece& piece :
           row_pieces(*this, whole_row ? 0 : first.x(), whole_row ? n.x() : last.x(), y, z)) {
        if (piece.length > 0) entered(piece.slot, static_cast<std::size_t>(piece.length));
      }
    }
  }
}

}  // namespace ldm
