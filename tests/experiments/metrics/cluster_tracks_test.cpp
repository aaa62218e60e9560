#include "experiments/metrics/cluster_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "datasets/scenario/simulation.h"
#include "experiments/method/data_folders.h"
#include "experiments/method/evaluation.h"
#include "experiments/metrics/matching.h"

namespace experiments {
namespace {

using Ids = std::vector<std::int64_t>;

constexpr double kFrame = 0.1;  // [s]

/// A standing or walking person.
ldm::Cluster person(double x, double y = 0, double vx = 0) {
  return {.position = {static_cast<float>(x), static_cast<float>(y), 1},
          .size = {0.5F, 0.5F, 1.8F},
          .velocity = {static_cast<float>(vx), 0, 0},
          .voxels = 40,
          .dynamic = vx != 0};
}

/// Two people side by side, seen as one cluster.
ldm::Cluster merged(const ldm::Cluster& a, const ldm::Cluster& b) {
  const ldm::Point half = 0.5F * (a.position - b.position).cwiseAbs();
  return {.position = 0.5F * (a.position + b.position),
          .size = a.size + 2.0F * half,
          .velocity = 0.5F * (a.velocity + b.velocity),
          .voxels = a.voxels + b.voxels,
          .dynamic = true};
}

TEST(ClusterTracks, NumberNewClustersFromOne) {
  ClusterTracks tracks;
  EXPECT_EQ(tracks.next(0, {person(0), person(3), person(6)}), (Ids{1, 2, 3}));
  EXPECT_EQ(tracks.next(kFrame, {}), Ids{});
}

TEST(ClusterTracks, KeepTheirNumbersWhateverTheOrder) {
  ClusterTracks tracks;
  tracks.next(0, {person(0), person(3), person(6)});
  EXPECT_EQ(tracks.next(kFrame, {person(6.05), person(9), person(0.05)}), (Ids{3, 4, 1}));
}

TEST(ClusterTracks, FollowTheVelocity) {
  // They change places.
  ClusterTracks tracks;
  tracks.next(0, {person(0, 0, 2), person(2, 0, -2)});
  tracks.next(kFrame, {person(0.2, 0, 2), person(1.8, 0, -2)});
  EXPECT_EQ(tracks.next(0.6, {person(1.2, 0, 2), person(0.8, 0, -2)}), (Ids{1, 2}));
}

TEST(ClusterTracks, OutlastAnOcclusionOfThreeSeconds) {
  ClusterTracks tracks;
  const ldm::Cluster standing = person(2, -1);
  for (double t = 0; t < 1; t += kFrame) tracks.next(t, {person(t, 0, 1), standing});
  for (double t = 1; t < 4; t += kFrame) {
    EXPECT_EQ(tracks.next(t, {standing}), Ids{2});
  }
  // It reappears half a metre from where its velocity leads, half of it still hidden.
  ldm::Cluster half = person(4.5, 0, 1);
  half.size.x() = 0.2F;
  half.voxels = 15;
  EXPECT_EQ(tracks.next(4, {standing, half}), (Ids{2, 1}));
}

TEST(ClusterTracks, EndInTimeAndAreNeverUsedAgain) {
  ClusterTracks tracks;
  for (double t = 0; t < 1; t += kFrame) tracks.next(t, {person(0)});
  for (int k = 0; k <= ClusterTracks::kMemoryFrames; ++k) tracks.next(1.1 + kFrame * k, {});
  EXPECT_EQ(tracks.next(1.1 + ClusterTracks::kMemory, {person(0)}), Ids{2});
}

TEST(ClusterTracks, SeenForAMomentOnlyAreForgottenSoon) {
  ClusterTracks tracks;
  tracks.next(0, {person(0)});
  for (int k = 1; k < 10; ++k) tracks.next(kFrame * k, {});
  EXPECT_EQ(tracks.next(2, {person(0)}), Ids{2});
}

/// Scans at 1 Hz, or with stamps that count them.
TEST(ClusterTracks, MemoryCountsInFramesToo) {
  ClusterTracks tracks;
  for (int k = 0; k < 5; ++k) EXPECT_EQ(tracks.next(k, {person(0)}), Ids{1});
  tracks.next(10, {});  // a track of 4 s, unseen for 6 s
  EXPECT_EQ(tracks.next(11, {person(0)}), Ids{1});
}

TEST(ClusterTracks, TwoWhoMeetAndPartKeepTheirNumbers) {
  // They walk towards each other along lines 0.4 m apart: for 0.8 s they are one cluster.
  ClusterTracks tracks;
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

TEST(ClusterTracks, TheLargerPartOfAClusterThatBreaksKeepsItsNumber) {
  ClusterTracks tracks;
  ldm::Cluster wall = person(0);
  wall.size = {6, 0.3F, 2};
  tracks.next(0, {wall});
  ldm::Cluster large = wall, small = wall;
  large.position.x() -= 1;
  large.size.x() = 4;
  small.position.x() += 2.25F;
  small.size.x() = 1;
  EXPECT_EQ(tracks.next(kFrame, {small, large}), (Ids{2, 1}));
  EXPECT_EQ(tracks.next(2 * kFrame, {wall}), Ids{1});
}

TEST(ClusterTracks, APersonIsNotTakenForAWall) {
  ClusterTracks tracks;
  ldm::Cluster wall = person(0);
  wall.size = {6, 0.3F, 2};
  tracks.next(0, {wall});
  EXPECT_EQ(tracks.next(kFrame, {person(0)}), Ids{2});
}

TEST(ClusterTracks, ObjectsOfAScenarioSeldomChangeTheirTrack) {
  ldm::Parameters parameters;
  parameters.particles.count = 20000;
  const Method& method = find_method("ldm");
  datasets::Simulation source(datasets::read_scenario(DataFolders({}).scenarios.file("scenario3")),
                              1, 300);
  ClusterTracks tracks;
  TruthGrid grid;
  struct Last {
    double time = 0;
    std::int64_t track = 0;
  };
  std::map<std::int32_t, Last> last;  // by object
  std::int64_t matched = 0, switches = 0;
  const auto observe = [&](const datasets::Frame& frame, const ldm::LocalMap& map) {
    const Ids ids = tracks.next(frame.scan.time, map.clusters);
    ASSERT_EQ(std::set(ids.begin(), ids.end()).size(), ids.size());
    grid.fill(*frame.truth, map.window, map.resolution);
    const Matching matching = match(map, grid);
    for (std::size_t i = 0; i < matching.objects.size(); ++i) {
      const auto cluster = matching.objects[i].cluster;
      if (!cluster) continue;
      ++matched;
      const Last now{frame.scan.time, ids[*cluster]};
      Last& before = last[frame.truth->objects[i].id];
      const bool lately = now.time - before.time < ClusterTracks::kMemory;
      if (before.track != 0 && lately && before.track != now.track) ++switches;
      before = now;
    }
  };
  evaluate(method, parameters, source, {.frames = {}, .series = false, .observer = observe});
  EXPECT_GT(matched, 1000);
  EXPECT_LT(switches, matched / 60);  // most by objects whose clusters merge and break
}

}  // namespace
}  // namespace experiments
