/// KITTI folders: poses by hand, and what is broken named with its place.
#include "datasets/recording/formats/kitti_reader.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <limits>

#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

class Kitti : public RecordingFolder {};

TEST_F(Kitti, WithoutCalibrationThePosesAreTheSensors) {
  write_drive(3);
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = static_cast<double>(k);
    EXPECT_EQ(all[k].index, static_cast<std::int64_t>(k));
    EXPECT_DOUBLE_EQ(all[k].scan.time, 0.1 * x);
    EXPECT_EQ(all[k].scan.T_world_sensor.translation, Eigen::Vector3d(x, 0, 0));
    EXPECT_EQ(all[k].scan.T_world_uav.translation, Eigen::Vector3d(x, 0, 0));
    ASSERT_EQ(all[k].scan.points.size(), 1u);
    EXPECT_EQ(all[k].scan.points[0], ldm::Point(10 + static_cast<float>(k), 1, 2));
    EXPECT_TRUE(all[k].scan.no_returns.empty());
    EXPECT_FALSE(all[k].truth);
  }
}

TEST_F(Kitti, WithCalibrationThePosesAreTheCameras) {
  write_drive(1);
  // Camera axes x right, y down, z forward; the camera sits 0.3 m before the LiDAR. It has moved
  // 2 m forward (its z) and turned a quarter to the left (about its y, negatively).
  write("calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: 0 -1 0 0  0 0 -1 0  1 0 0 -0.3\n");
  write("poses.txt", "0 0 -1 0  0 1 0 0  1 0 0 2\n");
  const ldm::Pose pose = frames().at(0).scan.T_world_sensor;
  // The LiDAR's forward axis then looks to the world's left; it sits 0.3 m behind the camera.
  EXPECT_TRUE((pose.rotation * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_TRUE(pose.translation.isApprox(Eigen::Vector3d(2.3, -0.3, 0), 1e-12));
}

TEST_F(Kitti, TheSensorsPlaceOnTheVehicle) {
  write_drive(2);
  options_.input.sensor = {true, 1, 0, 1.7, 0, 0, 90};  // looks to the left
  EXPECT_TRUE(frames()[1].scan.T_world_uav.translation.isApprox(Eigen::Vector3d(1, 1, -1.7)));
  options_.input.poses_of = PosesOf::kVehicle;
  const ldm::Scan scan = frames()[1].scan;
  EXPECT_TRUE(scan.T_world_uav.translation.isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(scan.T_world_sensor.translation.isApprox(Eigen::Vector3d(2, 0, 1.7)));
  EXPECT_TRUE(
      (scan.T_world_sensor * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(2, 1, 1.7)));
}

TEST_F(Kitti, ATumTrajectoryIsInterpolatedAtTheTimes) {
  write_drive(3);
  options_.input.pose_gap = 0.3;
  options_.poses = write("slam.tum",
                         "# time x y z qx qy qz qw\n-0.05 0 0 0 0 0 0 1\n0.15 4 0 0 0 0 0 1\n"
                         "0.25 5 0 0 0 0 0 1\n");
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR(all[0].scan.T_world_sensor.translation.x(), 1, 1e-12);
  EXPECT_NEAR(all[1].scan.T_world_sensor.translation.x(), 3, 1e-12);
  EXPECT_NEAR(all[2].scan.T_world_sensor.translation.x(), 4.5, 1e-12);
  options_.input.pose_gap = 0.15;
  EXPECT_NE(failure().find("times.txt:1: no pose at 0 s: " + path("slam.tum") +
                           " has poses at -0.05 and 0.15 s, allowed: a gap of input.pose_gap_s"),
            std::string::npos)
      << failure();
}

TEST_F(Kitti, AStandingSensorNeedsNoPoses) {
  write_drive(2);
  fs::remove(folder_ / "poses.txt");
  EXPECT_NE(failure().find("poses.txt: is missing: allowed: a trajectory there"),
            std::string::npos);
  options_.input.poses = PoseSource::kStill;
  EXPECT_EQ(frames()[1].scan.T_world_sensor.translation, Eigen::Vector3d::Zero());
  options_.input.poses = PoseSource::kOdometry;
  EXPECT_NE(failure(), "none");
}

/// Nothing tells which line or scan is missing: with --keep-going, too, the rest would be paired
/// with what belongs to the one before.
TEST_F(Kitti, TextFilesOneLineShortOrLong) {
  for (const bool keep_going : {false, true}) {
    options_.keep_going = keep_going;
    write_drive(3);
    write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n");
    EXPECT_EQ(failure(), path("poses.txt") + ": 2 lines: allowed: 3, as many as " +
                             path("times.txt") + " has");
    write("times.txt", "0\n0.1\n");
    EXPECT_EQ(failure(), path("times.txt") + ": 2 lines: allowed: 3, one for each scan of " +
                             path("velodyne") + ": nothing tells which belongs to which");
    write("times.txt", "0\n\n0.2\n");  // a blank time is none
    EXPECT_NE(failure().find("times.txt: 2 lines: allowed: 3"), std::string::npos);
    write_drive(3);
    append("times.txt", "0.3\n");
    append("poses.txt", "1 0 0 3 0 1 0 0 0 0 1 0\n");
    EXPECT_NE(failure().find("times.txt: 4 lines: allowed: 3"), std::string::npos);
  }
}

TEST_F(Kitti, ScansNumberedFromOneOrWithoutZerosInFront) {
  write_drive(11);
  fs::rename(folder_ / "velodyne", folder_ / "all");
  for (int k = 0; k < 11; ++k) {
    char name[32];
    std::snprintf(name, sizeof name, "all/%06d.bin", k);
    fs::create_directories(folder_ / "velodyne");
    fs::rename(folder_ / name, folder_ / "velodyne" / (std::to_string(k + 1) + ".BIN"));
  }
  write("velodyne/._1.BIN", "of another system");
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 11u);
  EXPECT_EQ(all[10].scan.points.at(0).x(), 20);
  EXPECT_EQ(all[10].scan.T_world_sensor.translation.x(), 10);
}

TEST_F(Kitti, NamesMayBeTimesInNanoseconds) {
  write_drive(2);
  fs::rename(folder_ / "velodyne/000000.bin", folder_ / "velodyne/1561000444390857630.bin");
  fs::rename(folder_ / "velodyne/000001.bin", folder_ / "velodyne/1561000444489636410.bin");
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].scan.points.at(0).x(), 11);
}

TEST_F(Kitti, PosesOfTheSensorBesideACalibration) {
  write_drive(2);
  write("calib.txt", "Tr: 0 -1 0 0  0 0 -1 0  1 0 0 -0.3\n");
  options_.input.poses_of = PosesOf::kSensor;
  EXPECT_EQ(frames().at(1).scan.T_world_sensor.translation, Eigen::Vector3d(1, 0, 0));
  options_.input.poses_of = PosesOf::kVehicle;
  options_.input.sensor.z = 2;
  EXPECT_EQ(frames().at(1).scan.T_world_sensor.translation, Eigen::Vector3d(1, 0, 2));
  options_.input.poses_of = PosesOf::kCamera;
  EXPECT_TRUE(
      frames().at(1).scan.T_world_sensor.translation.isApprox(Eigen::Vector3d(0, -1, 0), 1e-12));
  fs::remove(folder_ / "calib.txt");
  EXPECT_EQ(failure(), "input.poses_of = camera: allowed: in a KITTI folder with a calib.txt");
}

/// nuScenes: x, y, z, intensity, ring; in files whose size would do for four floats as well.
TEST_F(Kitti, PointsOfFiveFloats) {
  write_drive(1);
  const auto write_five = [&](float sign) {
    std::string bytes;
    for (int k = 0; k < 32; ++k) {
      const auto x = static_cast<float>(k + 1);
      const float numbers[] = {x, sign * x, sign * 0.5F, 7, static_cast<float>(k)};
      bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    }
    write("velodyne/000000.bin", bytes);
  };
  write_five(-1);
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.at(0).scan.points.size(), 32u);
  EXPECT_EQ(all[0].scan.points[20], ldm::Point(21, -21, -0.5F));
  options_.input.bin_columns = BinColumns::kFour;
  EXPECT_EQ(frames().at(0).scan.points.size(), 40u);
  options_.input.bin_columns = BinColumns::kAuto;
  write_five(1);  // nothing negative: both are possible
  EXPECT_NE(failure().find("000000.bin: its points may have 4 or 5 numbers: allowed: --set "
                           "input.bin_columns=4 (KITTI) or 5 (nuScenes)"),
            std::string::npos)
      << failure();
  options_.input.bin_columns = BinColumns::kFive;
  EXPECT_EQ(frames().at(0).scan.points.size(), 32u);
  write_drive(1);
  EXPECT_NE(failure().find("byte 16: the file ends: allowed: 20 bytes for each point"),
            std::string::npos);
}

TEST_F(Kitti, AStandingSensorSitsWhereTheVehicleHasIt) {
  write_drive(1);
  options_.input.poses = PoseSource::kStill;
  options_.input.sensor = {true, 0, 0, 2, 180, 0, 0};
  const ldm::Scan scan = frames().at(0).scan;
  EXPECT_EQ(scan.T_world_uav.translation, Eigen::Vector3d::Zero());
  EXPECT_EQ(scan.T_world_sensor.translation, Eigen::Vector3d(0, 0, 2));
  EXPECT_TRUE(
      (scan.T_world_sensor * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(1, -2, -1)));
}

TEST_F(Kitti, BrokenLinesNameThemselves) {
  write_drive(3);
  write("times.txt", "0\nnoon\n0.2\n");
  expect_broken("times.txt", "times.txt:2: noon: allowed: a finite number", 2, "bad time");
  write("times.txt", "0\n0.2\n0.1\n");
  expect_broken("times.txt", "times.txt:3: time 0.1 s: allowed: more than 0.2 s", 2,
                "time goes backwards");
  write("times.txt", "0\n0.1 7\n0.2\n");
  expect_broken("times.txt", "times.txt:2: 2 numbers: allowed: 1", 2, "bad time");
  write_drive(3);
  write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1\n1 0 0 0 0 1 0 0 0 0 1 0\n");
  expect_broken("poses.txt", "poses.txt:2: 11 numbers: allowed: 12", 2, "bad pose");
  write("poses.txt",
        "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 -1 0\n1 0 0 1e9 0 1 0 0 0 0 1 0\n");
  expect_broken("poses.txt", "poses.txt:2: the first three columns are no rotation", 1, "bad pose",
                2);
}

TEST_F(Kitti, ScansMissingOrCutShort) {
  write_drive(4);
  write("velodyne/000002.bin", kitti_bytes({{1, 2, 3}, {4, 5, 6}}).substr(0, 30));
  expect_broken("velodyne/000002.bin", "byte 30: the file ends", 3, "broken scan");
  write("velodyne/000002.bin", "");
  expect_broken("velodyne/000002.bin", "byte 0: the file ends", 3, "broken scan");
  fs::resize_file(folder_ / "velodyne/000002.bin", std::uintmax_t{3} << 30);  // of no blocks
  expect_broken("velodyne/000002.bin", "3221225472 bytes: allowed: at most 2 GB", 3, "broken scan");
  fs::remove(folder_ / "velodyne/000002.bin");
  expect_broken("times.txt", "times.txt:3: its scan is missing in " + path("velodyne"), 3,
                "missing scan");
  const std::vector<Frame> rest = frames();
  ASSERT_EQ(rest.size(), 3u);
  EXPECT_EQ(rest[2].scan.points.at(0).x(), 13);
  EXPECT_EQ(rest[2].scan.T_world_sensor.translation.x(), 3);
  EXPECT_EQ(rest[2].index, 3);  // the number of the scan in the recording
}

TEST_F(Kitti, FoldersWithoutScans) {
  options_.format = RecordingFormat::kKitti;
  EXPECT_NE(failure().find(path("velodyne") + ": cannot be read (No such file"), std::string::npos);
  fs::create_directory(folder_ / "velodyne");
  EXPECT_EQ(failure(), path("velodyne") + ": has no scans (*.bin)");
}

TEST_F(Kitti, Calibrations) {
  write_drive(1);
  write("calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_NE(failure().find("calib.txt: has no line `Tr:`"), std::string::npos) << failure();
  write("calib.txt", "Tr: 1 0 0 0 0 1 0 0 0 0 2 0\n");
  EXPECT_NE(failure().find("calib.txt:1: the first three columns"), std::string::npos);
}

TEST_F(Kitti, RepeatedScansAreLeftOutAndCounted) {
  write_drive(4);
  write("times.txt", "0\n0.1\n0.1\n0.4\n");
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[2].index, 3);
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"time of the frame before", 1}}));
}

TEST_F(Kitti, MemoryDoesNotGrowWithTheDrive) {
  write_drive(300);
  const auto source = open_recording(folder_, options_);
  std::vector<std::size_t> heap;
  heap.reserve(300);
  for (Frame frame; source->next(frame);) heap.push_back(mallinfo2().uordblks);
  ASSERT_EQ(heap.size(), 300u);
  EXPECT_LE(heap[299], heap[20] + 1024);
}

}  // namespace
}  // namespace datasets
