#include "experiments/runs/truth_score.h"

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace experiments {
namespace {

using RunFrames = std::map<std::int64_t, RunFrame>;

const Eigen::AlignedBox3d kMap(Eigen::Vector3d(-5, -5, 0), Eigen::Vector3d(5, 5, 4));

RunCluster cluster(std::int64_t track, double x, double vx = 0) {
  RunCluster found;
  found.track = track;
  found.position = {x, 0, 1};
  found.velocity = {vx, 0, 0};
  found.dynamic = vx != 0;
  return found;
}

/// 1 m wide.
TruthObject object(std::int64_t id, double x, double vx = 0) {
  return {.id = id,
          .dynamic = vx != 0,
          .position = {x, 0, 1},
          .velocity = {vx, 0, 0},
          .size = {1, 1, 1}};
}

TEST(TruthScore, AddsUpTheErrorsOfEachObject) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(1, 0), cluster(2, 3.25, 1.5)}}},
                         {1, {0.1, kMap, {cluster(1, 0.5, 0.25)}}}};
  const TruthTable truth = {{0, {{}, {object(10, 0), object(20, 3, 1)}}},
                            {1, {{}, {object(10, 0), object(20, 3, 1)}}}};
  const TruthScore result = score(run, truth, 0.5);
  EXPECT_EQ(result.frames, 2);
  const ObjectScore& standing = result.objects.at(10).score;
  EXPECT_EQ(standing.frames, 2);
  EXPECT_EQ(standing.matched(), 2);
  EXPECT_DOUBLE_EQ(*standing.position_error.value(), 0.25);
  EXPECT_DOUBLE_EQ(*standing.velocity_error.value(), 0.125);
  const ObjectScore& walking = result.objects.at(20).score;
  EXPECT_EQ(walking.frames, 2);
  EXPECT_EQ(walking.matched(), 1);
  EXPECT_DOUBLE_EQ(*walking.velocity_error.value(), 0.5);
  EXPECT_DOUBLE_EQ(*result.recall.value(), 0.5);     // of the walking one's two frames
  EXPECT_DOUBLE_EQ(*result.precision.value(), 0.5);  // of two dynamic clusters
  EXPECT_EQ(result.dynamic_on_static, 1);            // frame 1 calls the standing object dynamic
  EXPECT_EQ(result.of_dynamic.frames, 2);
  EXPECT_EQ(result.of_static.objects, 1);
}

TEST(TruthScore, ACentroidMayLieBesideTheBoxByTheGate) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(1, 0.9)}}}};
  const TruthTable truth = {{0, {{}, {object(10, 0)}}}};
  EXPECT_EQ(score(run, truth, 0.5).objects.at(10).score.matched(), 1);
  EXPECT_EQ(score(run, truth, 0.3).objects.at(10).score.matched(), 0);
}

TEST(TruthScore, EachClusterStandsForOneObjectTheNearest) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(1, 0.4)}}}};
  const TruthTable truth = {{0, {{}, {object(10, 0), object(20, 0.7)}}}};
  const TruthScore result = score(run, truth, 0.5);
  EXPECT_EQ(result.objects.at(10).score.matched(), 0);
  EXPECT_EQ(result.objects.at(20).score.matched(), 1);
}

TEST(TruthScore, CountsChangesOfIdentity) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(1, 0)}}},
                         {1, {0.1, kMap, {cluster(2, 0)}}},
                         {2, {0.2, kMap, {}}},
                         {3, {0.3, kMap, {cluster(1, 0)}}},
                         {4, {0.4, kMap, {cluster(1, 0)}}}};
  TruthTable truth;
  for (std::int64_t frame = 0; frame < 5; ++frame) truth[frame] = {{}, {object(10, 0)}};
  const ObjectScore result = score(run, truth, 0.5).objects.at(10).score;
  EXPECT_EQ(result.tracks, 2);
  EXPECT_EQ(result.switches, 2);
  EXPECT_EQ(result.frames, 5);
  EXPECT_EQ(result.matched(), 4);
}

TEST(TruthScore, ATrackOfNobodyIsNoTrack) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(5, 0)}}},
                         {1, {0.1, kMap, {cluster(0, 0)}}},
                         {2, {0.2, kMap, {cluster(5, 0)}}}};
  const TruthFrame truth{{}, {object(10, 0)}};
  const ObjectScore found =
      score(run, {{0, truth}, {1, truth}, {2, truth}}, 0.5).objects.at(10).score;
  EXPECT_EQ(found.switches, 0);
  EXPECT_EQ(found.tracks, 1);
}

TEST(TruthScore, AnObjectThatComesBackIntoTheMapIsNoSwitch) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(1, 4.9)}}},
                         {1, {0.1, kMap, {}}},
                         {2, {0.2, kMap, {cluster(2, 4.9)}}}};
  const TruthTable truth = {
      {0, {{}, {object(10, 4.9)}}}, {1, {{}, {object(10, 5.3)}}}, {2, {{}, {object(10, 4.9)}}}};
  const ObjectScore result = score(run, truth, 0.5).objects.at(10).score;
  EXPECT_EQ(result.tracks, 2);
  EXPECT_EQ(result.switches, 0);
}

TEST(TruthScore, ObjectsOutOfTheMapDoNotCount) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(1, 5.2)}}}};
  const TruthTable truth = {{0, {{}, {object(10, 5.3), object(20, 80)}}}};
  const TruthScore result = score(run, truth, 0.5);
  EXPECT_TRUE(result.objects.empty());
  EXPECT_EQ(result.dynamic_without_object, 0);
}

TEST(TruthScore, CountsDynamicClustersWithoutAnObject) {
  const RunFrames run = {{0, {0.0, kMap, {cluster(1, -3, 1), cluster(2, 3), cluster(3, 0)}}},
                         {1, {0.1, kMap, {cluster(1, -3, 1)}}}};
  const TruthTable truth = {{0, {{}, {object(10, 0)}}}};
  EXPECT_EQ(score(run, truth, 0.5).dynamic_without_object, 1);  // frame 1 is not judged
}

TEST(TruthScore, ComparesTheFramesOfBoth) {
  const RunFrames run = {{0, {0.0, kMap, {}}}, {1, {0.1, kMap, {}}}};
  const TruthScore result =
      score(run, {{1, {0.1, {object(10, 0)}}}, {2, {0.2, {object(10, 0)}}}}, 0.5);
  EXPECT_EQ(result.frames, 1);
  EXPECT_EQ(result.not_run, 1);
  EXPECT_NE(tests::message_of([&] {
              score(run, {{2, {}}}, 0.5);
            }).find("no frame of the truth is in the run"),
            std::string::npos);
  EXPECT_NE(tests::message_of([&] {
              score(run, {{1, {0.2, {}}}}, 0.5);
            }).find("frame 1: time_s = 0.200000: allowed: 0.100000"),
            std::string::npos);
}

}  // namespace
}  // namespace experiments
