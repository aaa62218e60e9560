#include "ldm/cluster_tracker.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace ldm {
namespace {

using Ids = std::vector<std::int64_t>;

constexpr double kFrame = 0.1;  // [s]

/// A standing or walking person.
Cluster person(double x, double y = 0, double vx = 0) {
  return {.position = {static_cast<float>(x), static_cast<float>(y), 1},
          .size = {0.5F, 0.5F, 1.8F},
          .velocity = {static_cast<float>(vx), 0, 0},
          .voxels = 40,
          .dynamic = vx != 0};
}

/// Two people side by side, seen as one cluster.
Cluster merged(const Cluster& a, const Cluster& b) {
  const Point half = 0.5F * (a.position - b.position).cwiseAbs();
  return {.position = 0.5F * (a.position + b.position),
          .size = a.size + 2.0F * half,
          .velocity = 0.5F * (a.velocity + b.velocity),
          .voxels = a.voxels + b.voxels,
          .dynamic = true};
}

/// The ids that a tracker gives, frame after frame.
class Followed {
 public:
  Ids next(double time, std::vector<Cluster> clusters) {
    tracker_.follow(time, clusters);
    Ids ids;
    for (const Cluster& cluster : clusters) ids.push_back(cluster.id);
    return ids;
  }

 private:
  ClusterTracker tracker_;
};

TEST(ClusterTracker, NumbersNewClustersFromOne) {
  Followed tracks;
  EXPECT_EQ(tracks.next(0, {person(0), person(3), person(6)}), (Ids{1, 2, 3}));
  EXPECT_EQ(tracks.next(kFrame, {}), Ids{});
}

TEST(ClusterTracker, KeepsTheirNumbersWhateverTheOrder) {
  Followed tracks;
  tracks.next(0, {person(0), person(3), person(6)});
  EXPECT_EQ(tracks.next(kFrame, {person(6.05), person(9), person(0.05)}), (Ids{3, 4, 1}));
}

TEST(ClusterTracker, FollowsTheVelocity) {
  // They change places.
  Followed tracks;
  tracks.next(0, {person(0, 0, 2), person(2, 0, -2)});
  tracks.next(kFrame, {person(0.2, 0, 2), person(1.8, 0, -2)});
  EXPECT_EQ(tracks.next(0.6, {person(1.2, 0, 2), person(0.8, 0, -2)}), (Ids{1, 2}));
}

TEST(ClusterTracker, OutlastsAnOcclusionOfThreeSeconds) {
  Followed tracks;
  const Cluster standing = person(2, -1);
  for (double t = 0; t < 1; t += kFrame) tracks.next(t, {person(t, 0, 1), standing});
  for (double t = 1; t < 4; t += kFrame) {
    EXPECT_EQ(tracks.next(t, {standing}), Ids{2});
  }
  // It reappears half a metre from where its velocity leads, half of it still hidden.
  Cluster half = person(4.5, 0, 1);
  half.size.x() = 0.2F;
  half.voxels = 15;
  EXPECT_EQ(tracks.next(4, {standing, half}), (Ids{2, 1}));
}

TEST(ClusterTracker, ForgetsInTimeAndUsesNoNumberAgain) {
  Followed tracks;
  for (double t = 0; t < 1; t += kFrame) tracks.next(t, {person(0)});
  for (int k = 0; k <= ClusterTracker::kMemoryFrames; ++k) tracks.next(1.1 + kFrame * k, {});
  EXPECT_EQ(tracks.next(1.1 + ClusterTracker::kMemory, {person(0)}), Ids{2});
}

TEST(ClusterTracker, ForgetsSoonWhatWasSeenForAMoment) {
  Followed tracks;
  tracks.next(0, {person(0)});
  for (int k = 1; k < 10; ++k) tracks.next(kFrame * k, {});
  EXPECT_EQ(tracks.next(2, {person(0)}), Ids{2});
}

/// Scans at 1 Hz, or with stamps that count them.
TEST(ClusterTracker, MemoryCountsInFramesToo) {
  Followed tracks;
  for (int k = 0; k < 5; ++k) EXPECT_EQ(tracks.next(k, {person(0)}), Ids{1});
  tracks.next(10, {});  // a track of 4 s, unseen for 6 s
  EXPECT_EQ(tracks.next(11, {person(0)}), Ids{1});
}

TEST(ClusterTracker, TwoWhoMeetAndPartKeepTheirNumbers) {
  // They walk towards each other along lines 0.4 m apart: for 0.8 s they are one cluster.
  Followed tracks;
  const auto left = [](double t) { return person(t - 2, 0, 1); };
  const auto right = [](double t) { return person(2 - t, 0.4, -1); };
  std::set<std::int64_t> while_merged;
  for (double t = 0; t < 4; t += kFrame) {
    if (std::abs(t - 2) < 0.4) {
      while_merged.insert(tracks.next(t, {merged(left(t), right(t))})[0]);
    } else {
      EXPECT_EQ(tracks.next(t, {left(t), right(t)}), (Ids{1, 2})) << t;
    }
  }
  ASSERT_EQ(while_merged.size(), 1u);
  EXPECT_LE(*while_merged.begin(), 2);
}

TEST(ClusterTracker, TheLargerPartOfAClusterThatBreaksKeepsItsNumber) {
  Followed tracks;
  Cluster wall = person(0);
  wall.size = {6, 0.3F, 2};
  tracks.next(0, {wall});
  Cluster large = wall, small = wall;
  large.position.x() -= 1;
  large.size.x() = 4;
  small.position.x() += 2.25F;
  small.size.x() = 1;
  EXPECT_EQ(tracks.next(kFrame, {small, large}), (Ids{2, 1}));
  EXPECT_EQ(tracks.next(2 * kFrame, {wall}), Ids{1});
}

TEST(ClusterTracker, APersonIsNotTakenForAWall) {
  Followed tracks;
  Cluster wall = person(0);
  wall.size = {6, 0.3F, 2};
  tracks.next(0, {wall});
  EXPECT_EQ(tracks.next(kFrame, {person(0)}), Ids{2});
}

TEST(ClusterTracker, AgeCountsFromTheFirstFrame) {
  ClusterTracker tracker;
  std::vector<Cluster> clusters{person(0)};
  tracker.follow(5, clusters);
  EXPECT_EQ(clusters[0].age, 0);
  tracker.follow(5.25, clusters);
  EXPECT_EQ(clusters[0].age, 0.25);
}

/// A person who walks at 1 m/s along x, of whom a method says a velocity with that error, after so
/// many seconds.
Cluster after(double seconds, const std::function<Eigen::Vector2d(int)>& error) {
  ClusterTracker tracker;
  std::vector<Cluster> clusters(1);
  for (int k = 0; k * kFrame <= seconds; ++k) {
    clusters[0] = person(k * kFrame, 0, 1);
    clusters[0].velocity.head<2>() += error(k).cast<float>();
    tracker.follow(k * kFrame, clusters);
  }
  return clusters[0];
}

TEST(ClusterTracker, OfANewObjectsVelocityNothingIsKnown) {
  const Cluster cluster = after(0, [](int) { return Eigen::Vector2d::Zero(); });
  EXPECT_TRUE(cluster.velocity_covariance.isApprox(Eigen::Matrix2f::Identity()));
  EXPECT_FALSE(cluster.dynamic);  // 1 m/s may be chance
}

TEST(ClusterTracker, TheCovarianceIsTheSquaredErrorAgainstTheWayMade) {
  const Cluster right = after(4, [](int) { return Eigen::Vector2d::Zero(); });
  EXPECT_LT(right.velocity_covariance.trace(), 2 * 0.1 * 0.1);
  EXPECT_TRUE(right.dynamic);
  const Cluster wrong = after(4, [](int) { return Eigen::Vector2d(0, 0.4); });
  EXPECT_NEAR(wrong.velocity_covariance(1, 1), 0.4 * 0.4, 0.02);
  EXPECT_LT(wrong.velocity_covariance(0, 0), 0.1 * 0.1);
}

TEST(ClusterTracker, WhatMayBeChanceIsNotDynamic) {
  // Slow errors of a standing person: 0.5 m/s, one way and then the other.
  ClusterTracker tracker;
  std::vector<Cluster> clusters(1);
  for (int k = 0; k < 60; ++k) {
    clusters[0] = person(0, 0, k / 5 % 2 == 0 ? 0.5 : -0.5);
    tracker.follow(k * kFrame, clusters);
    EXPECT_FALSE(clusters[0].dynamic) << k;
  }
}

TEST(ClusterTracker, WhatTheMethodCallsStaticStaysSo) {
  ClusterTracker tracker;
  std::vector<Cluster> clusters(1);
  for (int k = 0; k < 30; ++k) {
    clusters[0] = person(k * kFrame, 0, 1);
    clusters[0].dynamic = false;
    tracker.follow(k * kFrame, clusters);
  }
  EXPECT_FALSE(clusters[0].dynamic);
}

TEST(ClusterTracker, TwoFramesOfOneTimeTellNothingOfTheError) {
  ClusterTracker tracker;
  std::vector<Cluster> clusters{person(0)};
  tracker.follow(1, clusters);
  tracker.follow(1, clusters);
  EXPECT_EQ(clusters[0].id, 1);
  EXPECT_TRUE(clusters[0].velocity_covariance.isApprox(Eigen::Matrix2f::Identity()));
}

/// Which track was missed is told by frames, not by times.
TEST(ClusterTracker, TwoWhoMeetInAFrameOfTheSameTimeKeepTheirNumbers) {
  Followed tracks;
  const auto left = [](double t) { return person(t - 2, 0, 1); };
  const auto right = [](double t) { return person(2 - t, 0.4, -1); };
  double t = 0;
  for (; t < 1.7; t += kFrame) tracks.next(t, {left(t), right(t)});
  for (double before = t - kFrame; t < 2.3; before = t, t += kFrame) {
    tracks.next(before, {merged(left(t), right(t))});
    tracks.next(t, {merged(left(t), right(t))});
  }
  EXPECT_EQ(tracks.next(t, {left(t), right(t)}), (Ids{1, 2}));
}

}  // namespace
}  // namespace ldm
