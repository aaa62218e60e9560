/// The same seed gives the same bits: on any machine, with any number of threads.
#include <gtest/gtest.h>

#include "tests/ldm/box_scans.h"
#include "tests/ldm/map_fingerprint.h"

namespace ldm {
namespace {

/// All that the paper leaves open, so that another default does not change the fingerprint.
Parameters pinned() {
  Parameters parameters;
  parameters.survival = {true, 0.9, 0.98, 0.3};
  parameters.prediction = {SubVoxelMotion::kResidual, 0};
  parameters.particles = {29999,  // one more than pairs
                          0.8, 0.16, true, 20};
  parameters.clusters = {0.5, 0.2, true};
  return parameters;
}

/// A flight past a standing and a moving box; the state after every frame goes into the number.
std::uint64_t flight(std::int64_t threads, std::uint64_t seed) {
  Parameters parameters = pinned();
  parameters.execution.threads = threads;
  parameters.execution.seed = seed;
  LocalDynamicMap map(parameters);
  Fingerprint all;
  for (int k = 0; k < 15; ++k) {
    const double t = 0.125 * k;
    const Box standing{{1.5, 0.5, 1}, {0.5, 0.5, 1}};
    const Box moving{{-1 + 0.75 * t, -1.25, 1}, {0.5, 0.5, 1}};
    map.update(scan_of({standing, moving}, t, {0.25 * t, 0.125 * t, 1}));
    all.add(fingerprint(map));
  }
  return all.value();
}

class DeterminismTest : public testing::TestWithParam<std::int64_t> {};

TEST_P(DeterminismTest, GoldenFingerprint) {
  // A deliberate change of the arithmetic changes this number, and must say so here.
  EXPECT_EQ(flight(GetParam(), 1), 2930035866256491523U);
}

TEST_P(DeterminismTest, SameSeedSameBits) {
  EXPECT_EQ(flight(GetParam(), 5), flight(1, 5));
}

INSTANTIATE_TEST_SUITE_P(Threads, DeterminismTest, testing::Values(1, 2, 3, 4, 8));

TEST(SeedTest, AnotherSeedOtherBits) {
  EXPECT_NE(flight(1, 1), flight(1, 2));
}

}  // namespace
}  // namespace ldm
