#include "experiments/metrics/velocity_score.h"
#include "experiments/metrics/quantile.h"

#include <gtest/gtest.h>

#include <functional>

namespace experiments {
namespace {

using Vector = Eigen::Vector3d;

/// Ten frames a second; `change` edits each observation of an object in the map that is estimated
/// without error at 1 m/s along x.
VelocityTally play(int frames, const std::function<void(int, Observation&)>& change) {
  VelocityTally tally;
  for (int k = 0; k < frames; ++k) {
    Observation seen{.object = 3,
                     .dynamic = true,
                     .time = 0.1 * k,
                     .in_map = true,
                     .visible = true,
                     .true_velocity = Vector(1, 0, 0),
                     .velocity = Vector(1, 0, 0)};
    change(k, seen);
    tally.add(seen);
  }
  tally.finish();
  return tally;
}

TEST(VelocityScore, ErrorsCountFromTwoSecondsAfterEntering) {
  const VelocityTally tally = play(25, [](int k, Observation& seen) {
    seen.velocity = k < 20 ? Vector(9, 9, 9) : Vector(1, 0.3, 0.4);
  });
  EXPECT_EQ(tally.error(true).count(), 5);
  EXPECT_DOUBLE_EQ(*tally.error(true).value(), 0.5);
  EXPECT_FALSE(tally.error(false).value());
}

TEST(VelocityScore, LeavingTheMapStartsAnew) {
  const VelocityTally tally = play(45, [](int k, Observation& seen) {
    if (k == 20) seen.in_map = false;  // enters again at frame 21, counts from 41
  });
  EXPECT_EQ(tally.error(true).count(), 4);
}

TEST(VelocityScore, StaticAndDynamicObjectsAreApart) {
  VelocityTally tally;
  for (int k = 0; k <= 20; ++k) {
    for (const std::int32_t object : {0, 1}) {
      tally.add({.object = object,
                 .dynamic = object == 1,
                 .time = 0.1 * k,
                 .in_map = true,
                 .visible = true,
                 .true_velocity = Vector::Zero(),
                 .velocity = Vector(0.1 * (1 + object), 0, 0)});
    }
  }
  tally.finish();
  EXPECT_DOUBLE_EQ(*tally.error(false).value(), 0.1);
  EXPECT_DOUBLE_EQ(*tally.error(true).value(), 0.2);
}

TEST(VelocityScore, FramesWithoutClusterHaveNoErrorAndAreMissed) {
  const VelocityTally tally = play(40, [](int k, Observation& seen) {
    if (k >= 30) seen.velocity.reset();
    if (k >= 35) seen.visible = false;
  });
  EXPECT_EQ(tally.error(true).count(), 10);
  EXPECT_EQ(tally.missed().count(), 35);
  EXPECT_DOUBLE_EQ(*tally.missed().value(), 5.0 / 35);
}

TEST(VelocityScore, SteadyLeavesOutOneAndAHalfSecondsAfterAReversal) {
  // From frame 30 on it goes the other way; the estimate follows at once.
  const VelocityTally tally = play(60, [](int k, Observation& seen) {
    if (k >= 30) seen.true_velocity = Vector(-1, 0.2, 0);
    seen.velocity = seen.true_velocity;
  });
  EXPECT_EQ(tally.error(true).count(), 40);
  EXPECT_EQ(tally.steady_error(true).count(), 25);  // frames 20..29 and 45..59
}

TEST(VelocityScore, StopAndStartAreReversalsToo) {
  const VelocityTally tally = play(80, [](int k, Observation& seen) {
    if (k >= 30 && k < 40) seen.true_velocity.setZero();
    seen.velocity = seen.true_velocity;
  });
  EXPECT_EQ(tally.steady_error(true).count(), 35);  // frames 20..29 and 55..79
}

TEST(VelocityScore, ATurnByLessThanARightAngleIsSteady) {
  const VelocityTally tally = play(40, [](int k, Observation& seen) {
    if (k >= 30) seen.true_velocity = Vector(0.1, 1, 0);
  });
  EXPECT_EQ(tally.steady_error(true).count(), 20);
}

TEST(VelocityScore, AReversalOutOfTheMapIsSeen) {
  const VelocityTally tally = play(60, [](int k, Observation& seen) {
    seen.in_map = k < 10 || k >= 20;  // counts from frame 40
    if (k >= 35) seen.true_velocity = Vector(-1, 0, 0);
  });
  EXPECT_EQ(tally.error(true).count(), 20);
  EXPECT_EQ(tally.steady_error(true).count(), 10);  // from frame 50
}

TEST(VelocityScore, ConvergesWhereTheErrorBeginsToStayLow) {
  const VelocityTally tally = play(40, [](int k, Observation& seen) {
    if (k < 8 || k == 11) seen.velocity = Vector(0.5, 0, 0);  // good at 8, 9, 10: too short
  });
  EXPECT_NEAR(*tally.time_to_converge().value(), 1.2, 1e-9);
  EXPECT_EQ(*tally.not_converged().value(), 0);
}

TEST(VelocityScore, AMissedFrameBreaksConvergence) {
  const VelocityTally tally = play(40, [](int k, Observation& seen) {
    if (k % 5 == 0) seen.velocity.reset();
  });
  EXPECT_FALSE(tally.time_to_converge().value());
  EXPECT_EQ(*tally.not_converged().value(), 1);
}

TEST(VelocityScore, ShortStaysNeedNotConverge) {
  const VelocityTally tally = play(60, [](int k, Observation& seen) {
    seen.in_map = k < 15 || k >= 30;
    if (k < 15) seen.velocity = Vector::Zero();  // 1.4 s: too short to count
  });
  EXPECT_EQ(tally.not_converged().count(), 1);
  EXPECT_EQ(*tally.not_converged().value(), 0);
}

TEST(VelocityScore, ConvergenceIsOfDynamicObjects) {
  const VelocityTally tally = play(40, [](int, Observation& seen) { seen.dynamic = false; });
  EXPECT_FALSE(tally.time_to_converge().value());
  EXPECT_FALSE(tally.not_converged().value());
}

/// It turns at frame 30, and the estimate is right from frame 34 on, and once before.
TEST(VelocityScore, RecoveryEndsWithTheFirstOfTwoGoodFrames) {
  const VelocityTally tally = play(60, [](int k, Observation& seen) {
    if (k >= 30) seen.true_velocity = Vector(-1, 0, 0);
    if (k == 31 || k >= 34) seen.velocity = Vector(-0.85, 0, 0);
  });
  ASSERT_EQ(tally.recoveries().size(), 1u);
  EXPECT_NEAR(tally.recoveries()[0], 0.4, 1e-9);
}

TEST(VelocityScore, ATurnThatIsNeverFollowedHasTheTimeUntilTheNext) {
  const VelocityTally tally = play(60, [](int k, Observation& seen) {
    if (k >= 20 && k < 35) seen.true_velocity = Vector(-1, 0, 0);  // 1.5 s
    if (k >= 52) seen.true_velocity = Vector(-1, 0, 0);            // 0.7 s: tells nothing
  });
  // The second turn, back, is followed at once: the estimate never was another.
  ASSERT_EQ(tally.recoveries().size(), 2u);
  EXPECT_NEAR(tally.recoveries()[0], 1.5, 1e-9);
  EXPECT_NEAR(tally.recoveries()[1], 0, 1e-9);
}

TEST(VelocityScore, TurnsOfWhatIsHiddenOrUnmatchedDoNotCount) {
  const VelocityTally tally = play(60, [](int k, Observation& seen) {
    if (k == 19) seen.visible = false;
    if (k == 39) seen.velocity.reset();
    if (k >= 20 && k < 40) seen.true_velocity = Vector(-1, 0, 0);
  });
  EXPECT_TRUE(tally.recoveries().empty());
}

TEST(VelocityScore, StaticErrorsHaveQuantiles) {
  const VelocityTally tally = play(30, [](int k, Observation& seen) {
    seen.dynamic = false;
    seen.true_velocity.setZero();
    seen.velocity = Vector(0.01 * (k - 19), 0, 0);  // from frame 20 on 0.01 to 0.1
  });
  EXPECT_NEAR(*tally.static_error_quantile(0.95), 0.1, 1e-12);
  EXPECT_NEAR(*tally.static_error_quantile(0.5), 0.05, 1e-12);
  EXPECT_FALSE(quantile({}, 0.5));
}

/// Of variance 0.01 m^2/s^2 along each axis, the ellipse reaches to 0.2448 m/s.
TEST(VelocityScore, AnEllipseHoldsTheTruthUpToItsEdge) {
  const VelocityTally tally = play(24, [](int k, Observation& seen) {
    seen.velocity = Vector(1, k < 21 ? 0.244 : 0.246, 5);  // upwards counts for nothing
    if (k != 23) seen.covariance = 0.01 * Eigen::Matrix2d::Identity();
  });
  EXPECT_EQ(tally.in_ellipse().count(), 3);
  EXPECT_DOUBLE_EQ(*tally.in_ellipse().value(), 1.0 / 3);
}

}  // namespace
}  // namespace experiments
