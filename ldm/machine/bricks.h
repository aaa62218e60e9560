#pragma once
/// Bricks: why a frame costs what the map holds, not how large it is (no paper section).
///
/// A brick is kBrick slots that follow one another. A voxel keeps its slot while the map moves, so
/// it keeps its brick. Two things are known of a brick without a look at its voxels: between which
/// bounds their log-odds are (`RingBuffer::range`), and whether a particle may be in it
/// (`SparseNumbers::any_in`). Every pass over the map goes from brick to brick, and into those
/// alone that have something for it:
///
/// - the occupancy update, unless one flag is all that a brick gets, and it changes nothing:
///   unknown space that no ray met, free space at the clamp;
/// - clustering, where the upper bound is above the threshold;
/// - weights and births, there and where particles are; counts are cleared where there were any.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ldm {

inline constexpr std::size_t kBrick = 64;  ///< slots

/// Bricks that hold so many slots; the last may be a part of one.
constexpr std::size_t bricks_of(std::size_t slots) {
  return (slots + kBrick - 1) / kBrick;
}

/// Bounds of some values: none lies outside, whether or not one lies on them.
template <class Value>
struct Range {
  Value low = std::numeric_limits<Value>::max();  ///< above `high`: of no value
  Value high = std::numeric_limits<Value>::lowest();

  static Range all() {
    return {std::numeric_limits<Value>::lowest(), std::numeric_limits<Value>::max()};
  }
  void include(const Range& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  /// All values are the same.
  bool is_one() const { return low == high; }
};

/// A number beside each slot, zero in most: cleared at the cost of the bricks in which it is not.
class SparseNumbers {
 public:
  SparseNumbers() = default;
  explicit SparseNumbers(std::size_t slots) : numbers_(slots), used_(bricks_of(slots)) {}

  bool empty() const { return numbers_.empty(); }  ///< there are no slots
  std::uint32_t operator[](std::size_t slot) const { return numbers_[slot]; }
  std::span<const std::uint32_t> all() const { return numbers_; }
  /// False if all numbers of a brick are zero.
  bool any_in(std::size_t brick) const { return used_[brick] != 0; }
  bool all_zero() const {
    for (std::size_t brick = 0; brick < used_.size(); ++brick) {
      const auto numbers = of(brick);
      if (any_in(brick) &&
          std::any_of(numbers.begin(), numbers.end(), [](auto n) { return n != 0; })) {
        return false;
      }
    }
    return true;
  }

  /// Writes numbers, in loops too tight for anything but two pointers.
  struct Writer {
    std::uint32_t* numbers;
    std::uint8_t* used;

    void add_one(std::size_t slot) const {
      ++numbers[slot];
      used[slot / kBrick] = 1;
    }
    void set(std::size_t slot, std::uint32_t number) const {
      numbers[slot] = number;
      used[slot / kBrick] = 1;
    }
  };
  Writer writer() { return {numbers_.data(), used_.data()}; }
  /// Zero in slots [first, first + n).
  void clear(std::size_t first, std::size_t n) {
    for (std::size_t brick = first / kBrick; brick * kBrick < first + n; ++brick) {
      if (!any_in(brick)) continue;
      const std::size_t begin = std::max(first, brick * kBrick);
      const std::size_t end = std::min(first + n, (brick + 1) * kBrick);
      std::fill(&numbers_[begin], &numbers_[begin] + (end - begin), 0U);
    }
  }
  /// Zero in all.
  void clear() {
    clear(0, numbers_.size());
    std::fill(used_.begin(), used_.end(), std::uint8_t{0});
  }
  /// The same, where no number but these is other than zero.
  void clear(std::span<const std::size_t> slots) {
    for (const std::size_t slot : slots) {
      numbers_[slot] = 0;
      used_[slot / kBrick] = 0;
    }
  }

 private:
  std::span<const std::uint32_t> of(std::size_t brick) const {
    const std::size_t first = brick * kBrick;
    return std::span(numbers_).subspan(first, std::min(kBrick, numbers_.size() - first));
  }

  std::vector<std::uint32_t> numbers_;
  std::vector<std::uint8_t> used_;  // per brick: a number may be other than zero
};

}  // namespace ldm
