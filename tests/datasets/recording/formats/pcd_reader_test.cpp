/// Folders of PCD files with the trajectories they may have.
#include "datasets/recording/formats/pcd_reader.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

std::string pcd(const std::string& points, int count = 1) {
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + std::to_string(count) +
         "\nHEIGHT 1\nDATA ascii\n" + points + "\n";
}

class PcdFolder : public RecordingFolder {
 protected:
  void SetUp() override {
    RecordingFolder::SetUp();
    write("scan2.pcd", pcd("2 0 0"));
    write("scan10.pcd", pcd("10 0 0"));
    write("scan1.pcd", pcd("1 0 0"));
  }
  static constexpr char kTum[] = "5 0 0 0 0 0 0 1\n5.1 1 0 0 0 0 0 1\n5.3 3 0 0 0 0 0 1\n";
};

TEST_F(PcdFolder, NumbersInNamesCountByTheirValue) {
  EXPECT_TRUE(natural_less("2.pcd", "10.pcd"));
  EXPECT_TRUE(natural_less("a2b3", "a2b12"));
  EXPECT_TRUE(natural_less("a", "a1"));
  EXPECT_TRUE(natural_less("007", "8"));
  EXPECT_TRUE(natural_less("01", "1") != natural_less("1", "01"));
  EXPECT_FALSE(natural_less("x", "x"));
}

TEST_F(PcdFolder, ATumTrajectoryWithALineForEachScan) {
  write("poses.txt", kTum);
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[2].scan.time, 5.3);
  EXPECT_EQ(all[2].scan.T_world_sensor.translation, Eigen::Vector3d(3, 0, 0));
  EXPECT_EQ(all[2].scan.points.at(0), ldm::Point(10, 0, 0));
  EXPECT_EQ(all[1].scan.points.at(0), ldm::Point(2, 0, 0));
}

TEST_F(PcdFolder, ATumTrajectoryInterpolatedAtItsTimes) {
  write("poses.txt", kTum);
  write("times.txt", "5.05\n5.15\n5.2\n");
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR(all[0].scan.T_world_sensor.translation.x(), 0.5, 1e-9);
  EXPECT_NEAR(all[2].scan.T_world_sensor.translation.x(), 2, 1e-9);
  EXPECT_EQ(all[2].scan.time, 5.2);
}

TEST_F(PcdFolder, AKittiTrajectoryNeedsTimes) {
  write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n");
  EXPECT_NE(failure().find("poses.txt: has no times: allowed: with times.txt"), std::string::npos);
  options_.times = write("clock.txt", "0\n0.1\n0.2\n");
  EXPECT_EQ(frames().at(2).scan.T_world_sensor.translation, Eigen::Vector3d(2, 0, 0));
}

TEST_F(PcdFolder, WithoutPosesTheSensorMustStandStillAndHaveTimes) {
  options_.input.poses = PoseSource::kStill;
  EXPECT_NE(failure().find("input.poses = still: needs times"), std::string::npos);
  write("times.txt", "0\n0.1\n0.2\n");
  EXPECT_EQ(frames().size(), 3u);
}

TEST_F(PcdFolder, NonFinitePointsAreDroppedAndCounted) {
  write("poses.txt", kTum);
  write("scan2.pcd", pcd("nan nan nan\n3 inf 3\n4 4 4", 3));
  EXPECT_EQ(frames().at(1).scan.points.size(), 1u);
  EXPECT_EQ(counts_.points_dropped, (InputCounts::ByReason{{"not finite", 2}}));
}

TEST_F(PcdFolder, AHeaderThatLiesNamesFileAndLine) {
  write("poses.txt", kTum);
  write("scan2.pcd", pcd("4 4 4", 2));
  expect_broken("scan2.pcd", "scan2.pcd:9: the file ends: allowed: 2 points", 2, "broken scan");
}

TEST_F(PcdFolder, ATrajectoryThatEndsEarlyOrGoesBack) {
  write("times.txt", "5\n5.3\n5.6\n");
  write("poses.txt", "5 0 0 0 0 0 0 1\n5.31 1 0 0 0 0 0 1\n");
  expect_broken("times.txt", "times.txt:3: no pose at 5.6 s: ", 2, "no pose");
  write("times.txt", "5\n5.25\n5.3\n");
  write("poses.txt", "5 0 0 0 0 0 0 1\n5.2 1 0 0 0 0 0 1\n5.1 1 0 0 0 0 0 1\n5.4 2 0 0 0 0 0 1\n");
  expect_broken("poses.txt", "poses.txt:3: its time lies before", 2, "bad pose");
}

}  // namespace
}  // namespace datasets
