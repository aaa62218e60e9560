/// A map settles: after some frames, an update or a reading takes nothing from the heap.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "baselines/circular_buffer.h"
#include "baselines/circular_buffer_pf.h"
#include "baselines/octomap.h"
#include "experiments/benchmarks/allocation_count.h"
#include "experiments/benchmarks/footprint.h"
#include "ldm/local_dynamic_map.h"
#include "tests/ldm/box_scans.h"

namespace benchmarks {
namespace {

constexpr int kWarmUp = 20;
constexpr int kFrames = 50;

ldm::Parameters parameters_with(std::int64_t threads) {
  ldm::Parameters parameters;
  parameters.particles.count = 50000;
  parameters.execution.threads = threads;
  return parameters;
}

/// A flight past standing boxes and one that crosses.
std::vector<ldm::Scan> flight(int frames) {
  std::vector<ldm::Scan> scans;
  for (int k = 0; k < frames; ++k) {
    const double t = 0.1 * k;
    const ldm::Box wall{{1.5, 0.5, 1}, {0.5, 0.5, 1}};
    const ldm::Box post{{-1.5, 1.25, 1}, {0.25, 0.25, 2}};
    const ldm::Box walker{{-1 + 0.75 * t, -1.25, 1}, {0.5, 0.5, 1}};
    scans.push_back(ldm::scan_of({wall, post, walker}, t, {0.25 * t, 0.125 * t, 1}));
  }
  return scans;
}

template <class Map>
Footprint footprint_of(const ldm::Parameters& parameters) {
  return footprint([&] { return std::make_unique<Map>(parameters); }, flight(kFrames), kWarmUp);
}

class FootprintTest : public testing::TestWithParam<std::int64_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, FootprintTest, testing::Values(1, 2));

TEST_P(FootprintTest, ASettledLocalDynamicMapTakesNothing) {
  const Footprint taken = footprint_of<ldm::LocalDynamicMap>(parameters_with(GetParam()));
  EXPECT_EQ(taken.update_blocks, 0);
  EXPECT_EQ(taken.read_blocks, 0);
}

TEST_P(FootprintTest, ASettledCircularBufferWithParticlesTakesNothing) {
  const Footprint taken = footprint_of<baselines::CircularBufferPf>(parameters_with(GetParam()));
  EXPECT_EQ(taken.update_blocks, 0);
  EXPECT_EQ(taken.read_blocks, 0);
}

TEST(FootprintTest, ASettledCircularBufferTakesNothing) {
  const Footprint taken = footprint_of<baselines::CircularBuffer>(parameters_with(1));
  EXPECT_EQ(taken.update_blocks, 0);
  EXPECT_EQ(taken.read_blocks, 0);
}

TEST(FootprintTest, OctomapGrows) {
  EXPECT_GT(footprint_of<baselines::Octomap>(parameters_with(1)).update_blocks, 100);
}

TEST(FootprintTest, MemoryBesideTheParticlesStaysBelow24BytesAVoxel) {
  ldm::Parameters parameters = parameters_with(1);
  parameters.map.voxels.setConstant(128);
  parameters.particles.count = 1'000'000;
  const auto make = [&] { return std::make_unique<ldm::LocalDynamicMap>(parameters); };
  const Footprint taken = footprint(make, flight(3), 3);
  EXPECT_LE(taken.bytes_beside_particles_per_voxel(parameters), 24);
  EXPECT_GE(taken.bytes_beside_particles_per_voxel(parameters), sizeof(float));  // the log-odds
}

/// What the compiler must not leave out.
void* volatile sink;

TEST(AllocationCount, SeesEveryWayToTheHeap) {
  const AllocationCount count;
  sink = new int(1);
  delete static_cast<int*>(sink);
  const std::int64_t after_new = count.blocks();
  sink = std::malloc(100);
  sink = std::realloc(sink, 100000);
  std::free(sink);
  const std::int64_t after_realloc = count.blocks();
  sink = std::calloc(10, 10);
  std::free(sink);
  sink = std::aligned_alloc(64, 640);
  std::free(sink);
  const std::int64_t after_aligned = count.blocks();
  EXPECT_EQ(after_new, 1);
  EXPECT_EQ(after_realloc, 3);
  EXPECT_EQ(after_aligned, 5);
  EXPECT_GE(count.peak_bytes(), 100000);
  EXPECT_LT(count.peak_bytes(), 110000);
}

}  // namespace
}  // namespace benchmarks
