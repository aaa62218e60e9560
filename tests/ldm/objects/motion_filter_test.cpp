#include "ldm/objects/motion_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace ldm {
namespace {

const Eigen::Matrix2d kMillimetres = 1e-5 * Eigen::Matrix2d::Identity();

Eigen::Vector2d velocity(const MotionFilter& filter) {
  return filter.state().mean.tail<2>();
}

TEST(MotionFilter, KnowsNothingOfTheVelocityAtFirst) {
  const MotionFilter filter({1, 2}, kMillimetres);
  EXPECT_EQ(filter.state().mean, Eigen::Vector4d(1, 2, 0, 0));
  EXPECT_EQ(filter.state().covariance(0, 0), 1e-5);
  EXPECT_EQ(filter.state().covariance(2, 2), 36);
  EXPECT_EQ(filter.probability_of_rest(), 0.25);
}

/// Two positions 0.1 s and 0.5 m apart: 5 m/s, as good as both are known, and rest is excluded.
TEST(MotionFilter, TwoPositionsGiveAVelocityByHand) {
  MotionFilter filter({0, 0}, kMillimetres);
  filter.predict(0.1);
  filter.update({0.5, 0}, kMillimetres);
  EXPECT_NEAR(velocity(filter).x(), 5, 0.1);
  EXPECT_NEAR(velocity(filter).y(), 0, 0.01);
  EXPECT_LT(filter.probability_of_rest(), 1e-3);
  // (1e-5 + 1e-5) / 0.1^2 and, of abrupt manoeuvres, up to a quarter of (30 * 0.1)^2.
  EXPECT_GT(filter.state().covariance(2, 2), 2e-3);
  EXPECT_LT(filter.state().covariance(2, 2), 3);
}

TEST(MotionFilter, WhatStandsComesToRest) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.003);
  MotionFilter filter({0, 0}, kMillimetres);
  for (int i = 0; i < 50; ++i) {
    filter.predict(0.1);
    filter.update({noise(random), noise(random)}, kMillimetres);
  }
  EXPECT_GT(filter.probability_of_rest(), 0.8);
  EXPECT_LT(velocity(filter).norm(), 0.01);
}

TEST(MotionFilter, FollowsAReversalWithinThreeViews) {
  MotionFilter filter({0, 0}, kMillimetres);
  double x = 0;
  for (int i = 0; i < 30; ++i) {
    filter.predict(0.1);
    filter.update({x += 0.1, 0}, kMillimetres);
  }
  EXPECT_NEAR(velocity(filter).x(), 1, 0.01);
  for (int i = 0; i < 3; ++i) {
    filter.predict(0.1);
    filter.update({x -= 0.1, 0}, kMillimetres);
  }
  EXPECT_NEAR(velocity(filter).x(), -1, 0.1);
}

TEST(MotionFilter, WithoutMeasurementItGoesOnAndKnowsLess) {
  MotionFilter filter({0, 0}, kMillimetres);
  for (int i = 1; i <= 20; ++i) {
    filter.predict(0.1);
    filter.update({0.1 * i, 0}, kMillimetres);
  }
  const double before = filter.state().covariance(0, 0);
  for (int i = 0; i < 5; ++i) filter.predict(0.1);
  EXPECT_NEAR(filter.state().mean.x(), 2.5, 0.1);
  EXPECT_GT(filter.state().covariance(0, 0), 10 * before);
}

/// Of what goes straight the 95 % ellipse holds the true velocity at least so often.
TEST(MotionFilter, CovarianceHoldsTheTruth) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 0.003);
  int held = 0, likely = 0, all = 0;
  for (int flight = 0; flight < 40; ++flight) {
    const Eigen::Vector2d v(0.3 + 0.05 * flight, 1 - 0.05 * flight);
    MotionFilter filter({0, 0}, kMillimetres);
    for (int i = 1; i <= 30; ++i) {
      filter.predict(0.1);
      filter.update(0.1 * i * v + Eigen::Vector2d(noise(random), noise(random)), kMillimetres);
      if (i < 10) continue;
      const Eigen::Vector2d error = velocity(filter) - v;
      const Eigen::Matrix2d covariance = filter.state().covariance.bottomRightCorner<2, 2>();
      held += error.dot(covariance.inverse() * error) < 5.99 ? 1 : 0;
      likely += error.dot(filter.velocity_covariance().inverse() * error) < 5.99 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(held, 0.93 * all);
  EXPECT_GT(likely, 0.93 * all);
}

/// On a straight way the chance of an abrupt turn makes most of the whole covariance, not of that
/// of the likely ways; at a turn both know that.
TEST(MotionFilter, UnlikelyTurnsAreNotInTheLikelyCovariance) {
  MotionFilter filter({0, 0}, kMillimetres);
  const auto see = [&](double x) {
    filter.predict(0.1);
    filter.update({x, 0}, kMillimetres);
  };
  for (int i = 1; i <= 30; ++i) see(0.1 * i);
  const double whole = filter.state().covariance(2, 2);
  const double likely = filter.velocity_covariance()(0, 0);
  EXPECT_LT(likely, 0.5 * whole);
  see(2.9);
  EXPECT_GT(filter.velocity_covariance()(0, 0), 10 * likely);
}

/// A Kalman filter by hand: after two positions, as uncertain as the acceleration of 2 m/s^2 says.
TEST(MotionFilter, WithoutManoeuvresItIsOneKalmanFilter) {
  MotionFilter filter({0, 0}, kMillimetres, false);
  filter.predict(0.1);
  filter.update({0.5, 0}, kMillimetres);
  EXPECT_EQ(filter.probability_of_rest(), 0);
  EXPECT_NEAR(velocity(filter).x(), 5, 0.01);
  // (1e-5 + 1e-5) / 0.1^2, and of the acceleration a third of (2 * 0.1)^2.
  EXPECT_NEAR(filter.velocity_covariance()(0, 0), 2e-3 + 0.04 / 3, 1e-4);
}

/// By hand: at rest at the origin, known to a millimetre or so, each fix says where the error is.
TEST(MotionFilter, WhatStandsTellsOfACommonError) {
  MotionFilter filter({0, 0}, kMillimetres);
  for (int i = 0; i < 50; ++i) {
    filter.predict(0.1);
    filter.update({0, 0}, kMillimetres);
  }
  filter.predict(0.1);
  const Fix unknown{.covariance = 1e-4 * Eigen::Matrix2d::Identity()};
  const auto evidence = filter.evidence({{0.01, -0.02}, kMillimetres}, unknown);
  const Eigen::Vector2d error = evidence.information.inverse() * evidence.vector;
  EXPECT_NEAR(error.x(), 0.01, 0.001);
  EXPECT_NEAR(error.y(), -0.02, 0.001);
  // The fix's own variance, and that of the position: less than this, and 4 mm of drift.
  EXPECT_GT(evidence.information(0, 0), 1 / 3.6e-5);
  EXPECT_LT(evidence.information(0, 0), 1 / 1e-5);
}

TEST(MotionFilter, WhatJustTurnedTellsHardlyAnything) {
  MotionFilter filter({0, 0}, kMillimetres);
  for (int i = 1; i <= 30; ++i) {
    filter.predict(0.1);
    filter.update({0.1 * i, 0}, kMillimetres);
  }
  filter.predict(0.1);
  const Fix small{.covariance = 1e-4 * Eigen::Matrix2d::Identity()};
  const double on_its_way = filter.evidence({{3.1, 0}, kMillimetres}, small).information(0, 0);
  const double turned = filter.evidence({{2.9, 0}, kMillimetres}, small).information(0, 0);
  EXPECT_LT(turned, 0.05 * on_its_way);
}

}  // namespace
}  // namespace ldm
