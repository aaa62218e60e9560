/// A scan that is refused leaves the map as it was.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/ldm/box_scans.h"
#include "tests/ldm/map_fingerprint.h"

namespace ldm {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class RefusedScansTest : public testing::Test {
 protected:
  RefusedScansTest() {
    for (int k = 0; k < 3; ++k) frame(map_, k);
  }

  static Parameters few_particles() {
    Parameters parameters;
    parameters.particles.count = 10000;
    return parameters;
  }

  static Scan scan(int k) {
    return scan_of({{{1.2, 0.1, 0}, {0.5, 0.5, 0.5}}}, 0.1 * k, {0.1 * k, 0, 0}, 15);
  }
  static void frame(LocalDynamicMap& map, int k) { map.update(scan(k)); }

  /// Scan 3 after `spoil` must be refused without a trace.
  void expect_no_trace(const std::function<void(Scan&)>& spoil) {
    LocalMap before;
    map_.read(before);
    const std::uint64_t state = fingerprint(map_);
    Scan bad = scan(3);
    spoil(bad);
    EXPECT_THROW(map_.update(bad), InvalidInput);

    LocalMap after;
    map_.read(after);
    EXPECT_EQ(after.window.origin, before.window.origin);
    EXPECT_EQ(after.occupancy, before.occupancy);
    EXPECT_EQ(after.labels, before.labels);
    ASSERT_EQ(after.clusters.size(), before.clusters.size());
    EXPECT_EQ(fingerprint(map_), state);
  }

  LocalDynamicMap map_{few_particles()};
};

TEST_F(RefusedScansTest, PointsAndDirectionsThatAreNotFinite) {
  expect_no_trace([](Scan& s) { s.points.back().z() = kNan; });
  expect_no_trace([](Scan& s) { s.points.front().x() = std::numeric_limits<float>::infinity(); });
  expect_no_trace([](Scan& s) { s.no_returns.back().y() = kNan; });
}

TEST_F(RefusedScansTest, PosesThatAreNotFinite) {
  expect_no_trace([](Scan& s) { s.T_world_uav.translation.x() = kInfinity; });
  expect_no_trace([](Scan& s) { s.T_world_sensor.translation.z() = -kInfinity; });
  expect_no_trace([](Scan& s) { s.T_world_sensor.rotation(1, 2) = kInfinity; });
}

TEST_F(RefusedScansTest, TimesThatAreNotFiniteOrGoBackwards) {
  expect_no_trace([](Scan& s) { s.time = kInfinity; });
  expect_no_trace([](Scan& s) { s.time = std::numeric_limits<double>::quiet_NaN(); });
  expect_no_trace([](Scan& s) { s.time = 0.19; });
}

/// Not even the clock remembers: the next good scan finds the map of one that never saw the bad.
TEST_F(RefusedScansTest, TheNextScanGoesOnAsIfNothingHadBeen) {
  expect_no_trace([](Scan& s) {
    s.time = 9;
    s.points.front().x() = kNan;
  });
  LocalDynamicMap other(few_particles());
  for (int k = 0; k < 3; ++k) frame(other, k);
  frame(map_, 3);
  frame(other, 3);
  EXPECT_EQ(fingerprint(map_), fingerprint(other));
}

TEST_F(RefusedScansTest, TheSameTimeAgainIsTaken) {
  Scan again = scan(2);
  EXPECT_NO_THROW(map_.update(again));
  const std::uint64_t state = fingerprint(map_);
  again.time = 0.1;
  EXPECT_THROW(map_.update(again), InvalidInput);
  EXPECT_EQ(fingerprint(map_), state);
}

}  // namespace
}  // namespace ldm
