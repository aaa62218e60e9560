/// Folders of .bin scans: nuScenes' five floats and times in names, or times beside.
#include "datasets/recording/formats/bin_folder_reader.h"

#include <gtest/gtest.h>

#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

class BinFolder : public RecordingFolder {
 protected:
  /// nuScenes' bytes: a point of each ring at (x, -ring, 0).
  static std::string nuscenes_bytes(float x) {
    std::string bytes;
    for (int ring = 0; ring < 32; ++ring) {
      const float numbers[] = {x, static_cast<float>(-ring), 0, 3, static_cast<float>(ring)};
      bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    }
    return bytes;
  }
  void write_scans() const {
    write("n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402927647951.pcd.bin", nuscenes_bytes(1));
    write("n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402928147847.pcd.bin", nuscenes_bytes(2));
  }
};

TEST_F(BinFolder, NuscenesIsReadWithNoOption) {
  write_scans();
  write("poses.txt", "1532402927.5 100 0 0 0 0 0 1\n1532402928.5 110 0 0 0 0 0 1\n");
  EXPECT_EQ(recognised_format(folder_), RecordingFormat::kBin);
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NEAR(all[0].scan.time, 1532402927.647951, 1e-6);
  EXPECT_NEAR(all[1].scan.time, 1532402928.147847, 1e-6);
  EXPECT_NEAR(all[0].scan.T_world_sensor.translation.x(), 101.47951, 1e-4);
  ASSERT_EQ(all[1].scan.points.size(), 32u);
  EXPECT_EQ(all[1].scan.points[5], ldm::Point(2, -5, 0));
}

TEST_F(BinFolder, TimesOfAnotherUnitBelongToTheTrajectory) {
  write_scans();
  options_.poses = write("ego.txt",
                         "1532402927500000 100 0 0 0 0 0 1\n"
                         "1532402928500000 110 0 0 0 0 0 1\n");
  EXPECT_NE(failure().find("they look like us: --time-unit us"), std::string::npos) << failure();
  options_.time_unit = TimeUnit::kMicroseconds;
  EXPECT_NEAR(frames().at(0).scan.T_world_sensor.translation.x(), 101.47951, 1e-4);
}

TEST_F(BinFolder, ATableOfTimesComesFirst) {
  write_scans();
  write("times.txt", "3\n4\n");
  write("poses.txt", "1 0 0 7 0 1 0 0 0 0 1 0\n1 0 0 8 0 1 0 0 0 0 1 0\n");
  const std::vector<Frame> all = frames();
  EXPECT_EQ(all.at(1).scan.time, 4);
  EXPECT_EQ(all[1].scan.T_world_sensor.translation.x(), 8);
}

TEST_F(BinFolder, NamesThatTellNoTimeNeedATable) {
  write_scans();
  write("last.bin", nuscenes_bytes(3));
  write("poses.txt", "1 0 0 7 0 1 0 0 0 0 1 0\n1 0 0 8 0 1 0 0 0 0 1 0\n1 0 0 9 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(failure(), path("poses.txt") +
                           ": has no times of the scans: allowed: with times.txt in "
                           "the folder of the scans, or --times FILE");
  fs::remove(folder_ / "last.bin");
  EXPECT_EQ(failure(), path("poses.txt") +
                           ": 3 lines: allowed: 2, as many as times in the names of "
                           "the scans has");
  write("9.999999999999999999.bin", nuscenes_bytes(3));  // a fraction of 18 digits is no time
  EXPECT_NE(failure().find("has no times of the scans"), std::string::npos) << failure();
}

TEST_F(BinFolder, WithoutPosesItIsRefused) {
  write_scans();
  EXPECT_EQ(failure(), path("poses.txt") +
                           ": is missing: allowed: a trajectory there, --poses FILE, or --set "
                           "input.poses=still for a sensor at rest");
  options_.input.poses = PoseSource::kStill;
  EXPECT_EQ(frames().size(), 2u);
}

class NuscenesTables : public BinFolder {
 protected:
  void SetUp() override {
    root_ = folder_;
    folder_ = root_ / "samples/LIDAR_TOP";
    BinFolder::SetUp();
    write_scans();
    write(kSamples,
          R"([{"token": "s0", "ego_pose_token": "e0", "calibrated_sensor_token": "c", "height": 0,)"
          R"("filename": "samples/LIDAR_TOP/)" +
              kFirst +
              R"(", "is_key_frame": true}, {"token": "s1", "ego_pose_token": "e1",)"
              R"("calibrated_sensor_token": "c", "filename": "samples/LIDAR_TOP/)" +
              kSecond +
              R"(", "prev": null}, {"ego_pose_token": "e2", "calibrated_sensor_token": "camera",)"
              R"("filename": "samples/CAM_FRONT/a.jpg"}])");
    // The car looks east, and then north.
    write(
        kPoses,
        R"([{"token": "e2", "rotation": [1, 0, 0, 0], "translation": [7, 7, 7]},)"
        R"({"token": "e0", "timestamp": 5, "rotation": [1, 0, 0, 0], "translation": [411, 1180, 0]},)"
        R"({"token": "e1", "rotation": [0.70710678, 0, 0, 0.70710678],)"
        R"("translation": [412, 1180, 0.5]}])");
    write(kSensors,
          R"([{"token": "c", "rotation": [1, 0, 0, 0], "translation": [0.94, 0, 1.84],)"
          R"("camera_intrinsic": []}, {"token": "camera", "rotation": [1, 0, 0, 0],)"
          R"("translation": [1, 0, 1], "camera_intrinsic": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}])");
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_;
  const std::string kFirst = "n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402927647951.pcd.bin";
  const std::string kSecond = "n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402928147847.pcd.bin";
  const std::string kTables = "../../v1.0-mini/";
  const std::string kSamples = kTables + "sample_data.json", kPoses = kTables + "ego_pose.json",
                    kSensors = kTables + "calibrated_sensor.json";
};

TEST_F(NuscenesTables, SayWhereCarAndSensorAre) {
  const auto expect_drive = [&] {
    const std::vector<Frame> all = frames();
    ASSERT_EQ(all.size(), 2u);
    const Eigen::Vector3d origin = all[0].origin;
    EXPECT_TRUE((all[0].scan.T_world_uav.translation + origin)
                    .isApprox(Eigen::Vector3d(411, 1180, 0), 1e-9));
    EXPECT_TRUE((all[0].scan.T_world_sensor.translation + origin)
                    .isApprox(Eigen::Vector3d(411.94, 1180, 1.84), 1e-9));
    EXPECT_TRUE((all[1].scan.T_world_sensor.translation + origin)
                    .isApprox(Eigen::Vector3d(412, 1180.94, 2.34), 1e-9));
    EXPECT_NEAR(all[1].scan.time, 1532402928.147847, 1e-6);
  };
  expect_drive();
  fs::rename(root_ / "v1.0-mini", folder_ / "v1.0-mini");  // beside the scans of one scene
  expect_drive();
  write("poses.txt", "1532402927.5 100 0 0 0 0 0 1\n1532402928.5 110 0 0 0 0 0 1\n");
  EXPECT_NEAR(frames().at(0).scan.T_world_sensor.translation.x(), 101.47951, 1e-4);
}

TEST_F(NuscenesTables, AScanWithoutAPoseIsMissed) {
  write(kPoses, R"([{"token": "e1", "rotation": [1, 0, 0, 0], "translation": [1, 2, 3]}])");
  EXPECT_EQ(failure(), "times in the names of the scans:1: no pose in nuScenes' tables");
  options_.keep_going = true;
  EXPECT_EQ(frames().size(), 1u);
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"no pose", 1}}));
}

TEST_F(NuscenesTables, KeepTheirScansWhereOthersAreMissing) {
  fs::rename(folder_ / kFirst, folder_ / "1.bin");
  fs::rename(folder_ / kSecond, folder_ / "3.bin");
  write("times.txt", "0\n1\n2\n3\n");
  write(kSamples,
        R"([{"ego_pose_token": "e0", "calibrated_sensor_token": "c", "filename": "1.bin"},)"
        R"({"ego_pose_token": "e1", "calibrated_sensor_token": "c", "filename": "3.bin"}])");
  options_.keep_going = true;
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"missing scan", 2}}));
  EXPECT_NEAR((all[0].scan.T_world_uav.translation + all[0].origin).x(), 411, 1e-9);
  EXPECT_NEAR((all[1].scan.T_world_uav.translation + all[1].origin).x(), 412, 1e-9);
}

TEST_F(NuscenesTables, ThatAreNoneAreRefused) {
  const auto refused = [&](const std::string& file, const std::string& text,
                           const std::string& message) {
    const std::string good = read(file);
    write(file, text);
    EXPECT_NE(failure().find(message), std::string::npos) << failure();
    write(file, good);
  };
  refused(kPoses, "[{", "ego_pose.json: no table: allowed: a list of rows in JSON");
  refused(kPoses, std::string(99, '['), "ego_pose.json: no table");
  refused(kPoses, R"([{"token": "e0", "rotation": [1, 0, 0], "translation": [1, 2, 3]}])",
          "ego_pose.json: a row without a pose: allowed: translation of 3 numbers");
  refused(kPoses, R"([{"token": "e0", "rotation": [2, 0, 0, 0], "translation": [1, 2, 3]}])",
          "ego_pose.json: a row without a pose");
  refused(kSamples, "[]", "sample_data.json: has none of the scans");
  refused(kSensors, "[]", "calibrated_sensor.json: has no row of the scans' sensor");
  refused(kSensors,
          R"([{"token": "c", "rotation": [1, 0, 0, 0], "translation": [0, 0, 1]},)"
          R"({"token": "c", "rotation": [1, 0, 0, 0], "translation": [0, 0, 2]}])",
          "calibrated_sensor.json: the scans' sensor sits in several places");
  options_.input.sensor.x = 1;
  EXPECT_NE(failure().find("the log says where its sensor sits"), std::string::npos);
  options_.input.sensor = {};
  fs::remove(folder_ / kSensors);
  EXPECT_NE(failure().find("calibrated_sensor.json: cannot be read (No such file"),
            std::string::npos);
  write("../../v1.0-trainval/sample_data.json", "[]");
  EXPECT_NE(failure().find("several tables of nuScenes"), std::string::npos);
}

}  // namespace
}  // namespace datasets
