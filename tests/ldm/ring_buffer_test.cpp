#include "ldm/ring_buffer.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/ldm/random_inputs.h"
#include "tests/reference/dense_grid.h"

namespace ldm {
namespace {

std::size_t modulo(int v, int n) {
  return static_cast<std::size_t>(((v % n) + n) % n);
}

/// The worked example of Fig. 4, in each of the five layers of a map of 5 voxels per axis. The
/// figure's index of an array cell is x + 5 y.
class Figure4Test : public testing::Test {
 protected:
  std::size_t index_in_layer(const VoxelIndex& v) const { return map_.index().slot(v) % 25; }
  Eigen::Vector2i offset() const { return map_.index().offset().head<2>(); }

  RingBuffer<int> map_{{5, 5, 5}};
};

// Eq. (6)
TEST_F(Figure4Test, OffsetAndOriginBeforeAndAfterTheMove) {
  EXPECT_EQ(offset(), Eigen::Vector2i(2, 2));
  EXPECT_EQ(map_.index().centre() - map_.index().window().origin, Eigen::Vector3i(2, 2, 2));
  EXPECT_EQ(index_in_layer(map_.index().window().origin), 18u);

  map_.recenter(map_.index().centre() + VoxelIndex(1, 1, 0));
  EXPECT_EQ(offset(), Eigen::Vector2i(1, 1));
  EXPECT_EQ(index_in_layer(map_.index().window().origin), 24u);
}

TEST_F(Figure4Test, EnteringVoxelsTakeOverTheCellsOfThoseThatLeft) {
  std::fill(map_.cells().begin(), map_.cells().end(), 7);
  std::set<std::size_t> entered;
  map_.recenter(map_.index().centre() + VoxelIndex(1, 1, 0), [&](std::size_t first, std::size_t n) {
    for (std::size_t slot = first; slot < first + n; ++slot) entered.insert(slot % 25);
  });
  // The paper names 3, 15, 16 and 23 of them.
  EXPECT_EQ(entered, (std::set<std::size_t>{3, 8, 13, 18, 23, 15, 16, 17, 19}));
  for (std::size_t slot = 0; slot < map_.cells().size(); ++slot) {
    EXPECT_EQ(map_.cells()[slot], entered.contains(slot % 25) ? 0 : 7) << "slot " << slot;
  }
}

TEST(RingIndexTest, OffsetIsTheVoxelInSlotZero) {
  Random random(1);
  for (const Eigen::Vector3i& n : map_sizes()) {
    RingIndex index(n);
    for (int i = 0; i < 20; ++i) {
      index.recenter(random_vector(-100, 100, random), [](std::size_t, std::size_t) {});
      EXPECT_EQ(index.slot(index.window().origin + index.offset()), 0u);
    }
  }
}

TEST(RingIndexTest, VoxelLiesInItsIndexModuloTheSize) {
  Random random(2);
  for (const Eigen::Vector3i& n : map_sizes()) {
    RingIndex index(n);
    for (int i = 0; i < 20; ++i) {
      const VoxelIndex centre = random_vector(-100, 100, random);
      index.recenter(centre, [](std::size_t, std::size_t) {});
      EXPECT_EQ(index.centre(), centre);
      const VoxelIndex v = random_voxel(index.window(), random);
      const std::size_t expected =
          modulo(v.x(), n.x()) +
          static_cast<std::size_t>(n.x()) *
              (modulo(v.y(), n.y()) + static_cast<std::size_t>(n.y()) * modulo(v.z(), n.z()));
      EXPECT_EQ(index.slot(v), expected);
      const VoxelIndex d = v - index.window().origin;
      EXPECT_EQ(index.slot_of_local(d.x(), d.y(), d.z()), expected);
    }
  }
}

TEST(RingIndexTest, RefusesSizesOutOfRange) {
  for (const int n : {-1, 0, 4, 513}) {
    try {
      RingIndex({32, n, 32});
      ADD_FAILURE() << n << " was accepted";
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.what(), "map.voxels[1] = " + std::to_string(n) + ": allowed: 5 to 512");
    }
  }
}

TEST(RingIndexTest, TellsEachEnteringVoxelOnce) {
  Random random(3);
  for (const Eigen::Vector3i& n : map_sizes()) {
    RingIndex index(n);
    for (int i = 0; i < 30; ++i) {
      const VoxelBox before = index.window();
      const int reach = i % 3 == 0 ? n.maxCoeff() + 1 : 2;
      std::vector<int> entered(index.count(), 0);
      index.recenter(index.centre() + random_vector(-reach, reach, random),
                     [&](std::size_t first, std::size_t count) {
                       for (std::size_t s = first; s < first + count; ++s) ++entered.at(s);
                     });
      for_each_voxel(index.window(), [&](const VoxelIndex& v, std::size_t) {
        ASSERT_EQ(entered[index.slot(v)], before.contains(v) ? 0 : 1) << v.transpose();
      });
    }
  }
}

TEST(RowPiecesTest, FollowTheSlotsOfARow) {
  Random random(4);
  for (const Eigen::Vector3i& n : map_sizes()) {
    RingIndex index(n);
    for (int i = 0; i < 100; ++i) {
      index.recenter(random_vector(-50, 50, random), [](std::size_t, std::size_t) {});
      const int begin = uniform_int(0, n.x(), random);
      const int end = uniform_int(begin, n.x(), random);
      const int y = uniform_int(0, n.y() - 1, random);
      const int z = uniform_int(0, n.z() - 1, random);
      int next = begin;
      for (const RowPiece& piece : row_pieces(index, begin, end, y, z)) {
        EXPECT_EQ(piece.x, next);
        for (int k = 0; k < piece.length; ++k, ++next) {
          ASSERT_EQ(piece.slot + static_cast<std::size_t>(k), index.slot_of_local(next, y, z));
        }
      }
      EXPECT_EQ(next, end);
    }
  }
}

void expect_cells_within_ranges(const RingBuffer<int>& ring) {
  for (std::size_t slot = 0; slot < ring.cells().size(); ++slot) {
    const Range<int>& range = ring.range(slot / kBrick);
    ASSERT_LE(range.low, ring.cells()[slot]);
    ASSERT_GE(range.high, ring.cells()[slot]);
  }
}

/// A walk in small steps with now and then a leap, on which values are written here and there.
void compare_on_walk(const Eigen::Vector3i& n, Random& random) {
  RingBuffer<int> ring(n, -1);
  reference::DenseGrid<int> dense(n, -1);
  int value = 0;
  for (int step = 0; step < 25; ++step) {
    const int reach = step % 6 == 5 ? 2 * n.maxCoeff() : 3;
    const VoxelIndex centre = ring.index().centre() + random_vector(-reach, reach, random);
    ring.recenter(centre);
    dense.recenter(centre);
    ASSERT_EQ(ring.index().window().origin, dense.window().origin);
    for_each_voxel(ring.index().window(),
                   [&](const VoxelIndex& v, std::size_t) { ASSERT_EQ(ring.at(v), dense.at(v)); });
    expect_cells_within_ranges(ring);
    for (int i = 0; i < 100; ++i) {
      const VoxelIndex v = random_voxel(ring.index().window(), random);
      ring.at(v) = dense.at(v) = value++;
    }
  }
}

TEST(RingBufferTest, KeepsWhatADenseGridKeeps) {
  Random random(5);
  for (const Eigen::Vector3i& n : map_sizes()) {
    SCOPED_TRACE(testing::Message() << n.transpose());
    compare_on_walk(n, random);
  }
}

TEST(RingBufferTest, LeapsAcrossTheWholeWorld) {
  RingBuffer<int> map({5, 12, 33}, -1);
  for (const int far : {1000000000, -1000000000}) {  // 1e7 m at 1 cm a voxel
    std::fill(map.cells().begin(), map.cells().end(), 7);
    map.recenter(VoxelIndex::Constant(far));
    EXPECT_EQ(map.index().centre(), VoxelIndex::Constant(far));
    EXPECT_TRUE(std::all_of(map.cells().begin(), map.cells().end(), [](int c) { return c == -1; }));
    map.at(VoxelIndex::Constant(far)) = 3;
    map.recenter(VoxelIndex(far + 2, far, far - 1));
    EXPECT_EQ(map.at(VoxelIndex::Constant(far)), 3);
  }
}

TEST(RingBufferTest, RangesAreOfTheEmptyUntilCellsAreWritten) {
  const Eigen::Vector3i n(16, 16, 5);
  RingBuffer<int> map(n, -1);
  EXPECT_TRUE(map.range(0).is_one());
  EXPECT_FALSE(map.may_exceed(-1, 0, map.index().count()));
  EXPECT_TRUE(map.may_exceed(-2, 0, 1));
  map.in_slot(kBrick) = 4;  // the first of the second brick
  EXPECT_FALSE(map.may_exceed(3, 0, kBrick));
  EXPECT_TRUE(map.may_exceed(3, 0, kBrick + 1));
  EXPECT_TRUE(map.may_exceed(3, 2 * kBrick - 1, 1));
  EXPECT_FALSE(map.may_exceed(3, 2 * kBrick, 5));
  map.contents().ranges[1] = {4, 4};
  EXPECT_FALSE(map.may_exceed(4, 0, map.index().count()));
  map.recenter(VoxelIndex(1, 0, 0));  // a column of new voxels, some in each brick
  EXPECT_EQ(map.range(1).low, -1);
  EXPECT_EQ(map.range(1).high, 4);
  map.cells()[0] = 9;
  EXPECT_TRUE(map.may_exceed(8, 4 * kBrick, 1));
}

TEST(RingBufferTest, CellsAreEmptiedBeforeTheyAreTold) {
  RingBuffer<int> map({5, 5, 5}, -1);
  std::fill(map.cells().begin(), map.cells().end(), 7);
  std::size_t told = 0;
  map.recenter(VoxelIndex(0, 0, 2), [&](std::size_t first, std::size_t n) {
    for (std::size_t slot = first; slot < first + n; ++slot) EXPECT_EQ(map.cells()[slot], -1);
    told += n;
  });
  EXPECT_EQ(told, 50u);
}

}  // namespace
}  // namespace ldm
