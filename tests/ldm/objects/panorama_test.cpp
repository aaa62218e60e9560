#include "ldm/objects/panorama.h"

#include <gtest/gtest.h>

#include "tests/ldm/objects/lidar.h"

namespace ldm {
namespace {

/// A post 3 m before the sensor, which stands away from the origin.
class SeenPastTest : public testing::Test {
 protected:
  SeenPastTest() {
    NoisyLidar lidar;
    panorama_.fill(kSensor.head<2>(), lidar.returns(kSensor, {{{8, 1, 1}, {0.4, 0.4, 2}}}));
  }
  static inline const Eigen::Vector3d kSensor{5, 1, 1};
  Panorama panorama_;
};

TEST_F(SeenPastTest, SeesPastWhatLiesBeforeOrBesideAPost) {
  EXPECT_TRUE(panorama_.seen_past({6, 1}));
  EXPECT_TRUE(panorama_.seen_past({8, 1.5}));
  EXPECT_TRUE(panorama_.seen_past({2, 1}));  // behind the sensor nothing returns
}

TEST_F(SeenPastTest, SeesNotPastThePostNorWhatIsBehindOrJustBefore) {
  EXPECT_FALSE(panorama_.seen_past({7.8, 1}));
  EXPECT_FALSE(panorama_.seen_past({10, 1}));
  EXPECT_FALSE(panorama_.seen_past({7.65, 1}));
}

TEST_F(SeenPastTest, GoesAllRound) {
  EXPECT_LT(panorama_.nearest({1, 0}), 3);
  EXPECT_EQ(panorama_.nearest({-1, 1e-9}), panorama_.nearest({-1, -1e-9}));
}

}  // namespace
}  // namespace ldm
