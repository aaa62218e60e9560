/// Recorded logs as MRPT's own programs read them.
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CRawlog.h>
#include <unistd.h>

#include <filesystem>
#include <numbers>
#include <string>

#include "datasets/rawlog/rawlog.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

TEST(RawlogInMrpt, LoadsAsACRawlogOfObservations) {
  const fs::path folder =
      fs::temp_directory_path() / ("ldm_rawlog_mrpt_test_" + std::to_string(getpid()));
  fs::create_directory(folder);
  LidarModel lidar;
  lidar.elevations = {-0.1, 0.1};
  lidar.azimuths = 4;
  lidar.max_range = 50;
  Truth truth;
  truth.objects.resize(1);
  truth.objects[0].id = 3;
  truth.objects[0].position = {4, 5, 6};
  truth.noise_free_hits = {{1, 2, 3}};
  const RangeImage image{2, 4, {0, 1, 2, 3, 4, 5, 6, 65535}};
  // A quarter turn about z.
  const QuaternionPose pose{{7, 8, 9}, std::numbers::sqrt2 / 2, 0, 0, std::numbers::sqrt2 / 2};
  RawlogWriter writer(folder / "x.rawlog", lidar, {});
  writer.write(12.5, pose, image, truth);
  writer.close();

  mrpt::obs::CRawlog rawlog;
  const bool loaded = rawlog.loadFromRawLogFile((folder / "x.rawlog").string());
  fs::remove_all(folder);
  ASSERT_TRUE(loaded);
  ASSERT_EQ(rawlog.size(), 4u);
  const auto scan =
      std::dynamic_pointer_cast<mrpt::obs::CObservationRotatingScan>(rawlog.getAsObservation(0));
  const auto uav =
      std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(rawlog.getAsObservation(1));
  const auto object =
      std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(rawlog.getAsObservation(3));
  ASSERT_TRUE(scan && uav && object);

  EXPECT_EQ(scan->sensorLabel, "lidar");
  EXPECT_DOUBLE_EQ(mrpt::Clock::toDouble(scan->timestamp), 12.5);
  EXPECT_EQ(scan->rangeImage(0, 3), 3);
  EXPECT_EQ(scan->rangeImage(1, 3), 65535);
  EXPECT_DOUBLE_EQ(scan->rangeResolution, 0.002);
  EXPECT_DOUBLE_EQ(scan->startAzimuth, -std::numbers::pi);
  EXPECT_DOUBLE_EQ(scan->maxRange, 50);
  EXPECT_EQ(uav->sensorLabel, "uav");
  EXPECT_DOUBLE_EQ(uav->pose.mean.y(), 8);
  EXPECT_NEAR(uav->pose.mean.yaw(), std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(object->sensorLabel, "object_03");
  EXPECT_DOUBLE_EQ(object->pose.mean.z(), 6);
  EXPECT_EQ(rawlog.getAsObservation(2)->sensorLabel, "noise_free_hits");
}

}  // namespace
}  // namespace datasets
