/// KITTI's raw recordings: poses of the GPS/IMU by hand, and what is broken named with its place.
#include "datasets/recording/formats/kitti_raw_reader.h"

#include <gtest/gtest.h>

#include <numbers>

#include "datasets/recording/scans/oxts_trajectory.h"
#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

/// A degree of a great circle [m].
constexpr double kDegreeLength = 6378137 * std::numbers::pi / 180;

class KittiRaw : public RecordingFolder {
 protected:
  void SetUp() override {
    day_ = folder_;
    folder_ /= "2011_09_26_drive_0001_sync";
    RecordingFolder::SetUp();
  }
  void TearDown() override { fs::remove_all(day_); }

  static std::string numbered(const std::string& folder, int k, const std::string& ending) {
    char name[32];
    std::snprintf(name, sizeof name, "%010d", k);
    return folder + "/data/" + name + ending;
  }
  /// 30 numbers: where it is, how it is turned, and what nobody asks for.
  static std::string oxts(double latitude, double longitude, double altitude, double yaw) {
    std::ostringstream line;
    line.precision(12);
    line << latitude << ' ' << longitude << ' ' << altitude << " 0 0 " << yaw;
    for (int k = 6; k < 30; ++k) line << " 0.5";
    return line.str() + "\n";
  }
  static std::string time(double second) {
    char text[48];
    std::snprintf(text, sizeof text, "2011-09-26 13:02:%012.9f\n", second);
    return text;
  }
  /// Scan k is one point at (10 + k, 1, 2), taken at 25 + 0.1 k s; the IMU, measured 0.05 s before
  /// each and after the last, goes east by a thousandth of a degree a time, at a latitude of 60.
  void write_raw(int scans) const {
    std::string scan_times, oxts_times;
    for (int k = 0; k <= scans; ++k) {
      write(numbered("oxts", k, ".txt"), oxts(60, 8 + 0.001 * k, 110, 0));
      oxts_times += time(24.95 + 0.1 * k);
      if (k == scans) continue;
      write(numbered("velodyne_points", k, ".bin"),
            kitti_bytes({{10.0F + static_cast<float>(k), 1, 2}}));
      scan_times += time(25 + 0.1 * k);
    }
    write("velodyne_points/timestamps.txt", scan_times);
    write("oxts/timestamps.txt", oxts_times);
  }

  fs::path day_;
};

TEST_F(KittiRaw, IsReadWithNoOption) {
  write_raw(3);
  EXPECT_EQ(recognised_format(folder_), RecordingFormat::kKittiRaw);
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double step = 0.5 * 0.001 * kDegreeLength;  // half of what it is at the equator
    EXPECT_NEAR(all[k].scan.time, 1317042145 + 0.1 * static_cast<double>(k), 1e-6);
    EXPECT_NEAR(all[k].scan.T_world_uav.translation.x(), (static_cast<double>(k) + 0.5) * step,
                1e-3);
    EXPECT_NEAR(all[k].scan.T_world_uav.translation.tail<2>().norm(), 0, 1e-6);
    EXPECT_TRUE(all[k].scan.T_world_uav.rotation.isIdentity(1e-9));
    EXPECT_EQ(all[k].scan.points.at(0), ldm::Point(10 + static_cast<float>(k), 1, 2));
    EXPECT_EQ(all[k].scan.T_world_sensor.translation, all[k].scan.T_world_uav.translation);
  }
}

/// By the second order of ln tan(45 deg + latitude / 2), whose derivative is 1 / cos(latitude).
TEST_F(KittiRaw, NorthIsAsLongAsAGreatCircleNearTheFirstPose) {
  std::vector<double> numbers(30, 0);
  numbers[0] = 60;
  const double scale = 0.5;
  const ldm::Pose first = oxts_pose(numbers, scale);
  numbers[0] = 60.001;
  numbers[2] = 7;
  numbers[3] = 0.1;
  numbers[4] = 0.2;
  numbers[5] = 0.3;
  const ldm::Pose second = oxts_pose(numbers, scale);
  const double turn = 0.001 * std::numbers::pi / 180, tangent = std::sqrt(3.0);
  EXPECT_NEAR(second.translation.y() - first.translation.y(),
              0.001 * kDegreeLength * (1 + tangent * turn / 2), 1e-5);
  EXPECT_EQ(second.translation.x(), 0);
  EXPECT_EQ(second.translation.z(), 7);
  const Eigen::Matrix3d expected = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  EXPECT_TRUE(second.rotation.isApprox(expected, 1e-12));
}

TEST_F(KittiRaw, TheCalibrationSaysWhereTheScannerSits) {
  write_raw(1);
  for (int k = 0; k < 2; ++k) {
    write(numbered("oxts", k, ".txt"), oxts(49, 8, 110, std::numbers::pi / 2));  // looks north
  }
  const std::string calibration =
      "calib_time: 25-May-2012 16:47:16\nR: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.9\n";
  for (const char* place : {"../calib_imu_to_velo.txt", "calib_imu_to_velo.txt"}) {
    const fs::path file = write(place, calibration);
    const ldm::Scan scan = frames().at(0).scan;
    EXPECT_TRUE(scan.T_world_uav.translation.isZero(1e-6));
    EXPECT_TRUE(scan.T_world_sensor.translation.isApprox(Eigen::Vector3d(0.3, 0.8, 0.9), 1e-6));
    EXPECT_TRUE((scan.T_world_sensor.rotation * Eigen::Vector3d::UnitX())
                    .isApprox(Eigen::Vector3d::UnitY(), 1e-9));
    options_.input.sensor.z = 1;
    EXPECT_NE(failure().find("the log says where its sensor sits: allowed: input.sensor.*"),
              std::string::npos);
    options_.input.sensor.from_log = false;
    EXPECT_NEAR(frames().at(0).scan.T_world_sensor.translation.z(), 1, 1e-9);
    options_.input.sensor = {};
    write(place, "R: 1 0 0 0 1 0 0 0 1\n");
    EXPECT_NE(failure().find("calib_imu_to_velo.txt: has no lines `R:` and `T:`"),
              std::string::npos);
    write(place, "R: 1 0 0 0 1 0 0 0 2\nT: 0 0 0\n");
    EXPECT_NE(failure().find("R is no rotation matrix"), std::string::npos) << failure();
    fs::remove(file);
  }
}

TEST_F(KittiRaw, OtherPosesAreTheSensors) {
  write_raw(2);
  write("calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: -0.8 0 0\n");
  options_.poses = write("slam.txt", "1 0 0 5 0 1 0 0 0 0 1 0\n1 0 0 6 0 1 0 0 0 0 1 0\n");
  const ldm::Scan scan = frames().at(1).scan;
  EXPECT_EQ(scan.T_world_sensor.translation.x(), 6);
  EXPECT_NEAR(scan.T_world_uav.translation.x(), 5.2, 1e-12);
  options_.poses.reset();
  fs::remove_all(folder_ / "oxts");
  EXPECT_NE(failure().find(path("oxts") + ": is missing: allowed: a trajectory there"),
            std::string::npos);
}

TEST_F(KittiRaw, AMissingFileOfTheImuIsAGap) {
  write_raw(4);
  fs::remove(folder_ / numbered("oxts", 2, ".txt"));
  EXPECT_EQ(frames().size(), 4u);
  options_.input.pose_gap = 0.15;
  EXPECT_NE(failure().find("timestamps.txt:2: no pose at"), std::string::npos) << failure();
  fs::rename(folder_ / numbered("oxts", 3, ".txt"), folder_ / "oxts/data/later.txt");
  EXPECT_NE(failure().find("oxts/timestamps.txt: 5 lines: allowed: 4, one for each file of"),
            std::string::npos)
      << failure();
}

TEST_F(KittiRaw, BrokenFilesNameThemselves) {
  write_raw(3);
  const std::string file = numbered("oxts", 1, ".txt");
  for (const auto& [text, message] :
       {std::pair<std::string, std::string>{"49 8 110\n", "3 numbers: allowed: 30"},
        {"", "0 numbers: allowed: 30"},
        {oxts(91, 8, 110, 0), "no latitude and longitude in degrees"}}) {
    write(file, text);
    options_.keep_going = false;
    EXPECT_NE(failure().find(path(file) + ":1: " + message), std::string::npos) << failure();
    options_.keep_going = true;
    EXPECT_GE(frames().size(), 1u);
    EXPECT_EQ(counts_.frames_skipped.count("bad pose"), 1u);
  }
  options_.keep_going = false;
  write_raw(3);
  write("oxts/timestamps.txt", time(24.95) + "noon\n" + time(25.15) + time(25.25));
  EXPECT_NE(failure().find("oxts/timestamps.txt:2: noon: allowed: a finite number"),
            std::string::npos)
      << failure();
}

}  // namespace
}  // namespace datasets
