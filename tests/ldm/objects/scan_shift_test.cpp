#include "ldm/objects/scan_shift.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace ldm {
namespace {

const Eigen::Matrix2d kMillimetres = 1e-5 * Eigen::Matrix2d::Identity();

/// Objects whose places are known but for what the whole scan is displaced.
class ScanShiftTest : public testing::Test {
 protected:
  /// @param shift [m]
  /// @param ways of each object in this scan [m]
  void see(const Eigen::Vector2d& shift, const std::vector<Eigen::Vector2d>& ways) {
    if (filters_.empty()) {
      filters_.assign(ways.size(), MotionFilter({0, 0}, kMillimetres));
      places_.assign(ways.size(), Eigen::Vector2d::Zero());
    }
    shift_.begin(time_ += 0.1);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      places_[i] += ways[i];
      filters_[i].predict(0.1);
      shift_.add(static_cast<std::int64_t>(i) + 1, filters_[i], {places_[i] + shift, kMillimetres});
    }
    shift_.find();
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const Fix freed = shift_.freed(i);
      filters_[i].update(freed.position, freed.covariance);
    }
  }
  Eigen::Vector2d noise(double sigma) {
    return {sigma * normal_(random_), sigma * normal_(random_)};
  }

  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
  ScanShift shift_;
  double time_ = 0;
  std::vector<MotionFilter> filters_;
  std::vector<Eigen::Vector2d> places_;
};

TEST_F(ScanShiftTest, FindsHowLargeShiftsAre) {
  double sum = 0;
  for (int i = 0; i < 200; ++i) {
    see(noise(0.02), {{0, 0}, {0.1, 0}, {0, 0.05}});
    if (i >= 30) sum += shift_.sigma() / 170;
  }
  EXPECT_NEAR(sum, 0.02, 0.003);
}

TEST_F(ScanShiftTest, TakesNoneFromWhatTurnsAlone) {
  for (int i = 0; i < 60; ++i) {
    const double back_and_forth = i % 6 < 3 ? 0.1 : -0.1;
    see({0, 0}, {{0, 0}, {0.1, 0}, {back_and_forth, 0}});
    EXPECT_LT(shift_.sigma(), 0.002);
  }
}

/// What stands tells what to take from what moves.
TEST_F(ScanShiftTest, FreesAFixFromTheShift) {
  for (int i = 0; i < 40; ++i) see(noise(0.02), {{0, 0}, {0, 0}, {0.1, 0}});
  see({0.03, -0.04}, {{0, 0}, {0, 0}, {0.1, 0}});
  const Fix freed = shift_.freed(2);
  EXPECT_NEAR(freed.position.x(), 4.1, 0.01);
  EXPECT_NEAR(freed.position.y(), 0, 0.01);
  EXPECT_LT(freed.covariance(0, 0), 0.008 * 0.008);
}

/// Alone, an object is not told whether it is the pose that moves: its fix is less certain.
TEST_F(ScanShiftTest, LeavesALoneObjectUncertain) {
  for (int i = 0; i < 60; ++i) see(noise(0.02), {{0.1, 0}});
  EXPECT_NEAR(shift_.freed(0).covariance(0, 0), 1e-5 + shift_.sigma() * shift_.sigma(), 1e-9);
  EXPECT_GT(shift_.sigma(), 0.012);
  EXPECT_LT(shift_.sigma(), 0.028);
}

TEST_F(ScanShiftTest, IsNoneBeforeEnoughWasSeen) {
  for (int i = 0; i < 6; ++i) {
    see(noise(0.02), {{0, 0}, {0, 0}});
    EXPECT_EQ(shift_.sigma(), 0.001);
  }
  see(noise(0.02), {{0, 0}, {0, 0}});
  EXPECT_GT(shift_.sigma(), 0.005);
}

}  // namespace
}  // namespace ldm
