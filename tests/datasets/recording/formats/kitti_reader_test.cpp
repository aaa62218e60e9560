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

TEST_F(Kitti, TextFilesOneLineShortOrLong) {
  for (const char* name : {"times.txt", "poses.txt"}) {
    const std::string reason = name == std::string("times.txt") ? "no time" : "no pose";
    write_drive(3);
    const std::string whole = name == std::string("times.txt")
                                  ? "0\n0.1\n"
                                  : "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n";
    write(name, whole);
    expect_broken(name, "2 lines: allowed: 3, one for each scan, or --keep-going", 2, reason);
  }
  write_drive(3);
  append("times.txt", "0.3\n");
  expect_broken("times.txt", "4 lines: allowed: 3", 3, "missing scan");
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
  expect_broken("velodyne/000002.bin", "cannot be read (No such file", 3, "missing scan");
  const std::vector<Frame> rest = frames();
  EXPECT_EQ(rest[2].index, 3);  // the number of the scan in the recording
}

TEST_F(Kitti, FoldersWithoutScans) {
  options_.format = RecordingFormat::kKitti;
  EXPECT_NE(failure().find(path("velodyne") + ": cannot be read (No such file"), std::string::npos);
  fs::create_directory(folder_ / "velodyne");
  EXPECT_EQ(failure(), path("velodyne") + ": has no scans (NUMBER.bin)");
  write("velodyne/first.bin", kitti_bytes({{1, 2, 3}}));
  EXPECT_NE(failure().find("first.bin: allowed: numbers"), std::string::npos);
}

TEST_F(Kitti, Calibrations) {
  write_drive(1);
  write("calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_NE(failure().find("calib.txt: has no line `Tr:`"), std::string::npos) << failure();
  write("calib.txt", "Tr: 1 0 0 0 0 1 0 0 0 0 2 0\n");
  EXPECT_NE(failure().find("calib.txt:1: the first three columns"), std::string::npos);
  options_.input.poses_of = PosesOf::kVehicle;
  EXPECT_NE(failure().find("calib.txt: the poses are those of its camera"), std::string::npos);
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
