/// Folders of PCD files with the trajectories they may have.
#include "datasets/recording/formats/pcd_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

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
  EXPECT_NE(failure().find("poses.txt: has no times of the scans: allowed: with times.txt"),
            std::string::npos);
  options_.times = write("clock.txt", "0\n0.1\n0.2\n");
  EXPECT_EQ(frames().at(2).scan.T_world_sensor.translation, Eigen::Vector3d(2, 0, 0));
}

TEST_F(PcdFolder, WithoutPosesTheSensorMustStandStillAndHaveTimes) {
  options_.input.poses = PoseSource::kStill;
  EXPECT_NE(failure().find("input.poses = still: needs times"), std::string::npos);
  write("times.txt", "0\n0.1\n0.2\n");
  EXPECT_EQ(frames().size(), 3u);
}

/// At rest it is the vehicle that stands at the origin, level: the sensor sits on it.
TEST_F(PcdFolder, ASensorAtRestSitsOnTheVehicle) {
  options_.input.poses = PoseSource::kStill;
  options_.input.sensor.z = 2;
  options_.input.sensor.roll = 180;
  write("times.txt", "0\n0.1\n0.2\n");
  const ldm::Scan scan = frames().at(0).scan;
  EXPECT_EQ(scan.T_world_uav.translation, Eigen::Vector3d::Zero());
  EXPECT_TRUE(scan.T_world_sensor.translation.isApprox(Eigen::Vector3d(0, 0, 2)));
  const Eigen::Matrix3d upside_down = Eigen::Vector3d(1, -1, -1).asDiagonal();
  EXPECT_TRUE(scan.T_world_sensor.rotation.isApprox(upside_down, 1e-12));
}

TEST_F(PcdFolder, AScanThatMayNotBeReadIsCounted) {
  write("poses.txt", kTum);
  fs::permissions(folder_, fs::perms::all);
  fs::permissions(folder_ / "scan2.pcd", fs::perms::none);
  const uid_t user = geteuid();
  if (user == 0) {
    ASSERT_EQ(seteuid(65534), 0);  // root reads everything
  }
  const std::string refused = failure();
  options_.keep_going = true;
  const std::size_t read = frames().size();
  if (user == 0) {
    ASSERT_EQ(seteuid(user), 0);
  }
  EXPECT_NE(refused.find("scan2.pcd: cannot be read (Permission denied)"), std::string::npos)
      << refused;
  EXPECT_EQ(read, 2u);
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"unreadable scan", 1}}));
}

TEST_F(PcdFolder, NonFinitePointsAreDroppedAndCounted) {
  write("poses.txt", kTum);
  write("scan2.pcd", pcd("nan nan nan\n3 inf 3\n4 4 4", 3));
  EXPECT_EQ(frames().at(1).scan.points.size(), 1u);
  EXPECT_EQ(counts_.points_dropped, (InputCounts::ByReason{{"not finite", 2}}));
}

/// Times whose last zeros were cut off.
TEST_F(PcdFolder, NamesThatAreTimesStandInTheirOrder) {
  for (const char* name : {"scan1.pcd", "scan2.pcd", "scan10.pcd"}) fs::remove(folder_ / name);
  write("1667850622.25.pcd", pcd("1 0 0"));
  write("1667850622.3.pcd", pcd("2 0 0"));
  write("1667850622.35.PCD", pcd("3 0 0"));
  write("poses.txt", kTum);
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(all[k].scan.points.at(0).x(), static_cast<float>(k + 1));
}

TEST_F(PcdFolder, AHeaderLineAByteOrderMarkAndHiddenFiles) {
  write("._scan1.pcd", "of another system");
  write("poses.txt", "\xef\xbb\xbftimestamp tx ty tz qx qy qz qw\n" + std::string(kTum));
  EXPECT_EQ(frames().at(2).scan.T_world_sensor.translation, Eigen::Vector3d(3, 0, 0));
  write("times.txt", "time [s]\n5.05\n5.15\n5.2\n");
  EXPECT_EQ(frames().at(2).scan.time, 5.2);
  write("poses.txt", "time,x,y,z,qx,qy,qz,qw\n5,0,0,0,0,0,0,1\n");
  EXPECT_NE(failure().find("poses.txt:2: 1 numbers: allowed: 8 (TUM: time x y z qx qy qz qw) or 12 "
                           "(KITTI), between blanks"),
            std::string::npos)
      << failure();
}

TEST_F(PcdFolder, TimesInOtherUnits) {
  write("poses.txt",
        "1403638522827829504 0 0 0 0 0 0 1\n1403638522927829504 1 0 0 0 0 0 1\n"
        "1403638523027829504 2 0 0 0 0 0 1\n");
  for (const bool keep_going : {false, true}) {
    options_.keep_going = keep_going;
    EXPECT_EQ(failure(),
              path("poses.txt") +
                  ": times from 1403638522827829504 on: allowed: seconds; they look like "
                  "ns: --time-unit ns (or s, if they are right)");
  }
  options_.time_unit = TimeUnit::kNanoseconds;
  EXPECT_NEAR(frames().at(2).scan.time, 1403638523.0278, 1e-3);
  write("times.txt", "1403638522877829504\n1403638522977829504\n1403638522987829504\n");
  EXPECT_NEAR(frames().at(1).scan.T_world_sensor.translation.x(), 1.5, 1e-3);
  options_.time_unit.reset();
  write("poses.txt", kTum);
  write("times.txt", "5050\n5150\n5200\n");
  EXPECT_NE(failure().find("times.txt: times from 5050 on: allowed: seconds; they look like ms"),
            std::string::npos)
      << failure();
  options_.keep_going = false;
  options_.time_unit = TimeUnit::kSeconds;
  EXPECT_NE(failure().find("no pose at 5050 s"), std::string::npos) << failure();
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
