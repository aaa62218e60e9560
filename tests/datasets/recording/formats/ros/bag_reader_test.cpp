/// Bags of ROS 1 and 2: containers, layouts of messages, sources of poses, and what is refused.
#include "datasets/recording/formats/ros/bag_reader.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <numbers>

#include "datasets/recording/formats/ros/bag_contents.h"
#include "tests/datasets/recording/formats/ros/bag_writer.h"
#include "tests/datasets/recording/recording_folder.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

using Messages = std::vector<TestMessage>;

constexpr MessageEncoding kRos1 = MessageEncoding::kRos1, kCdr = MessageEncoding::kCdr;

Eigen::Quaterniond yaw(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
}

class Bags : public RecordingFolder {
 protected:
  static TestMessage cloud(MessageEncoding encoding, double stamp,
                           const std::vector<TestPoint>& points, const CloudLayout& layout = {},
                           const std::string& topic = "/points",
                           const std::string& frame = "lidar") {
    return {{topic, "sensor_msgs/PointCloud2", encoding},
            stamp + 0.01,
            cloud_bytes(encoding, stamp, frame, points, layout)};
  }
  static TestMessage tf(MessageEncoding encoding, const std::vector<TestTransform>& transforms,
                        bool fixed = false) {
    return {{fixed ? "/tf_static" : "/tf", "tf2_msgs/TFMessage", encoding},
            transforms.front().stamp + 0.01,
            tf_bytes(encoding, transforms)};
  }
  static TestMessage odometry(MessageEncoding encoding, const TestTransform& transform,
                              const std::string& topic = "/odom") {
    return {{topic, "nav_msgs/Odometry", encoding},
            transform.stamp + 0.01,
            odometry_bytes(encoding, transform)};
  }

  /// Scans at 100, 100.1, ... of one point (10 + k, 1, 2); the LiDAR sits 1 m above a base that is
  /// at (10 t, 0, 0) in a frame odom, which is at (0, 5, 0) in the map.
  static Messages drive(MessageEncoding encoding, int scans = 3) {
    Messages messages;
    messages.push_back(tf(encoding, {{0, "base", "lidar", {0, 0, 1}}}, true));
    for (int k = 0; k < scans; ++k) {
      const double time = 100 + 0.1 * k;
      messages.push_back({{"/imu", "sensor_msgs/Imu", encoding}, time, "not read"});
      messages.push_back(cloud(encoding, time, {{10.0 + k, 1, 2}}));
      messages.push_back(tf(encoding, {{time - 0.05, "odom", "base", {1.0 * k - 0.5, 0, 0}},
                                       {time - 0.05, "map", "odom", {0, 5, 0}}}));
    }
    messages.push_back(tf(encoding, {{100 + 0.1 * scans, "odom", "base", {1.0 * scans, 0, 0}},
                                     {100 + 0.1 * scans, "map", "odom", {0, 5, 0}}}));
    return messages;
  }

  std::vector<Frame> frames_of(const fs::path& bag) {
    std::vector<Frame> all;
    const auto source = open_recording(bag, options_);
    for (Frame frame; source->next(frame);) all.push_back(frame);
    counts_ = source->counts();
    return all;
  }
  std::vector<Frame> frames_of(const Messages& messages) {
    return frames_of(write("a.bag", ros1_bag(messages)));
  }
  std::string failure_of(const Messages& messages) {
    const fs::path bag = write("a.bag", ros1_bag(messages));
    try {
      frames_of(bag);
    } catch (const ldm::InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).rfind(bag.string() + ": ", 0), 0u) << error.what();
      return error.what();
    }
    return "none";
  }
  void expect_drive(const fs::path& bag) {
    const std::vector<Frame> all = frames_of(bag);
    ASSERT_EQ(all.size(), 3u) << bag;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = static_cast<double>(k);
      EXPECT_EQ(all[k].index, static_cast<std::int64_t>(k));
      EXPECT_NEAR(all[k].scan.time, 100 + 0.1 * x, 1e-9);
      EXPECT_TRUE(all[k].scan.T_world_sensor.translation.isApprox(Eigen::Vector3d(x, 5, 1), 1e-6))
          << all[k].scan.T_world_sensor.translation.transpose();
      EXPECT_TRUE(all[k].scan.T_world_uav.translation.isApprox(Eigen::Vector3d(x, 5, 0), 1e-6));
      ASSERT_EQ(all[k].scan.points.size(), 1u);
      EXPECT_EQ(all[k].scan.points[0], ldm::Point(10 + static_cast<float>(k), 1, 2));
    }
  }
};

TEST_F(Bags, OfRos1) {
  for (const char* compression : {"none", "lz4", "bz2"}) {
    expect_drive(write("a.bag", ros1_bag(drive(kRos1), compression)));
  }
}

TEST_F(Bags, OfRos2InMcap) {
  for (const char* compression : {"-", "", "lz4", "zstd"}) {
    expect_drive(write("a.mcap", mcap_bag(drive(kCdr), compression)));
  }
}

TEST_F(Bags, OfRos2InSqlite) {
  write_sqlite_bag(folder_ / "a #1.db3", drive(kCdr));
  expect_drive(folder_ / "a #1.db3");
}

TEST_F(Bags, SplitIntoSeveralFiles) {
  const Messages messages = drive(kCdr);
  const auto middle = messages.begin() + 5;
  write("bag/metadata.yaml", "rosbag2_bagfile_information:\n");
  write("bag/a_2.mcap", mcap_bag({messages.begin(), middle}, "zstd"));
  write("bag/a_10.mcap", mcap_bag({middle, messages.end()}, "zstd"));
  expect_drive(folder_ / "bag");
}

TEST_F(Bags, PointsOfAnyLayout) {
  const std::vector<TestPoint> points = {{1, 2, 3}, {NAN, NAN, NAN}, {4, 5, 6}, {0, 0, 0}};
  options_.input.poses = PoseSource::kStill;
  for (const std::uint8_t coordinate : {std::uint8_t{7}, std::uint8_t{8}}) {
    for (const std::uint32_t height : {1U, 2U}) {
      for (const std::uint8_t time :
           {std::uint8_t{0}, std::uint8_t{6}, std::uint8_t{7}, std::uint8_t{8}}) {
        const CloudLayout layout{coordinate, "time", time, height, height == 1 ? 0U : 5U};
        const std::vector<Frame> all = frames_of({cloud(kRos1, 100, points, layout)});
        EXPECT_EQ(all.at(0).scan.points, (std::vector<ldm::Point>{{1, 2, 3}, {4, 5, 6}}));
      }
    }
  }
  EXPECT_EQ(counts_.points_dropped,
            (InputCounts::ByReason{{"nearer than input.min_range_m", 1}, {"not finite", 1}}));
}

TEST_F(Bags, OdometryWhoseChildIsTheSensorOrSitsFixedToIt) {
  const Messages of_sensor = {cloud(kRos1, 100, {{1, 0, 0}}),
                              odometry(kRos1, {99.9, "odom", "lidar", {1, 0, 0}, yaw(0)}),
                              odometry(kRos1, {100.1, "odom", "lidar", {3, 0, 0}, yaw(1)})};
  const ldm::Scan scan = frames_of(of_sensor).at(0).scan;
  EXPECT_TRUE(scan.T_world_sensor.translation.isApprox(Eigen::Vector3d(2, 0, 0), 1e-6));
  EXPECT_TRUE(scan.T_world_sensor.rotation.isApprox(yaw(0.5).toRotationMatrix(), 1e-6));

  Messages of_base = {cloud(kRos1, 100, {{1, 0, 0}}),
                      odometry(kRos1, {100, "odom", "base", {1, 0, 0}, yaw(std::numbers::pi / 2)})};
  EXPECT_NE(
      failure_of(of_base).find("poses of base, scans of lidar, and no fixed transform between: "
                               "allowed: --sensor-frame, --set input.poses_of=sensor"),
      std::string::npos)
      << failure_of(of_base);
  of_base.insert(of_base.begin(), tf(kRos1, {{0, "base", "lidar", {2, 0, 0}}}, true));
  const ldm::Scan with_mount = frames_of(of_base).at(0).scan;
  EXPECT_TRUE(with_mount.T_world_sensor.translation.isApprox(Eigen::Vector3d(1, 2, 0), 1e-6));
  EXPECT_TRUE(with_mount.T_world_uav.translation.isApprox(Eigen::Vector3d(1, 0, 0), 1e-6));
  options_.input.poses_of = PosesOf::kSensor;
  EXPECT_TRUE(frames_of(of_base).at(0).scan.T_world_sensor.translation.isApprox(
      Eigen::Vector3d(1, 0, 0), 1e-6));
}

TEST_F(Bags, PosesAloneAreTheSensors) {
  const TestTransform pose{100, "map", "", {1, 2, 3}};
  const Messages messages = {
      cloud(kRos1, 100, {{1, 0, 0}}),
      {{"/pose", "geometry_msgs/PoseStamped", kRos1}, 100, pose_bytes(kRos1, pose)}};
  EXPECT_EQ(frames_of(messages).at(0).scan.T_world_sensor.translation, Eigen::Vector3d(1, 2, 3));
  options_.input.poses_of = PosesOf::kVehicle;
  options_.input.sensor.z = 2;
  EXPECT_EQ(frames_of(messages).at(0).scan.T_world_sensor.translation, Eigen::Vector3d(1, 2, 5));
}

TEST_F(Bags, PosesOfAFile) {
  const Messages messages = {cloud(kRos1, 100, {{1, 0, 0}}), cloud(kRos1, 100.1, {{1, 0, 0}})};
  EXPECT_NE(failure_of(messages).find("has no poses of lidar: allowed: --poses FILE"),
            std::string::npos);
  options_.poses = write("slam.tum", "99.9 0 0 0 0 0 0 1\n100.2 3 0 0 0 0 0 1\n");
  EXPECT_NEAR(frames_of(messages).at(1).scan.T_world_sensor.translation.x(), 2, 1e-6);
  // Without times: one for each scan.
  options_.poses = write("kitti.txt", "1 0 0 5 0 1 0 0 0 0 1 0\n1 0 0 6 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(frames_of(messages).at(0).scan.T_world_sensor.translation.x(), 5);
  EXPECT_EQ(frames_of(messages).at(1).scan.T_world_sensor.translation.x(), 6);
  append("kitti.txt", "1 0 0 7 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { frames_of(messages); }),
            path("kitti.txt") + ": 3 lines: allowed: 2, one for each scan of " + path("a.bag") +
                ", or a trajectory with times (TUM)");
}

TEST_F(Bags, ASensorAtRestStandsWhereTheVehicleHasIt) {
  Messages messages = {cloud(kRos1, 100, {{1, 0, 0}})};
  options_.input.poses = PoseSource::kStill;
  options_.input.sensor.z = 2;
  EXPECT_EQ(frames_of(messages).at(0).scan.T_world_sensor.translation.z(), 2);
  messages.insert(messages.begin(), tf(kRos1, {{0, "base", "lidar", {0, 0, 1}}}, true));
  EXPECT_NE(failure_of(messages).find("TF says where lidar sits in base"), std::string::npos);
  options_.input.sensor.z = 0;
  EXPECT_EQ(frames_of(messages).at(0).scan.T_world_sensor.translation.z(), 1);
}

TEST_F(Bags, AChoiceIsTheUsers) {
  Messages messages = drive(kRos1);
  messages.push_back(cloud(kRos1, 100.2, {{1, 0, 0}}, {}, "/rear"));
  EXPECT_NE(failure_of(messages).find("scans of several topics: allowed: --points with one of "
                                      "/points, /rear"),
            std::string::npos);
  options_.points = "/front";
  EXPECT_NE(failure_of(messages).find("--points /front: allowed: /points, /rear"),
            std::string::npos);
  options_.points = "/points";
  EXPECT_EQ(frames_of(messages).size(), 3u);
  messages.push_back(odometry(kRos1, {100, "odom", "base", {0, 0, 0}}, "/wheels"));
  messages.push_back(odometry(kRos1, {100, "odom", "base", {0, 0, 0}}, "/slam"));
  EXPECT_EQ(frames_of(messages).size(), 3u);  // TF that moves the sensor comes first
  options_.input.poses = PoseSource::kOdometry;
  EXPECT_NE(failure_of(messages).find("poses of several topics: allowed: --poses-topic with one of "
                                      "/wheels, /slam"),
            std::string::npos);
  options_.poses_topic = "/imu";
  EXPECT_NE(failure_of(messages).find("--poses-topic /imu: allowed: /wheels, /slam"),
            std::string::npos);
  options_.poses_topic = "/slam";
  options_.keep_going = true;
  EXPECT_EQ(frames_of(messages).size(), 2u);  // a little beyond the one pose
}

TEST_F(Bags, AFrameWithTwoParentsIsRefused) {
  Messages messages = drive(kRos1);
  messages.push_back(tf(kRos1, {{100.1, "camera_init", "base", {9, 9, 9}}}));
  EXPECT_NE(
      failure_of(messages).find("a frame has two parents in TF, base: odom, camera_init: allowed: "
                                "--poses-topic of nothing in this bag, or --poses FILE"),
      std::string::npos)
      << failure_of(messages);
}

TEST_F(Bags, TheSensorFrameMayBeNamed) {
  Messages messages = drive(kRos1);
  for (TestMessage& message : messages) {
    if (message.topic.name == "/points")
      message.bytes = cloud_bytes(kRos1, message.time, "os_sensor", {{1, 0, 0}});
  }
  EXPECT_NE(failure_of(messages).find("has no poses of os_sensor"), std::string::npos);
  options_.sensor_frame = "/lidar";
  EXPECT_EQ(frames_of(messages).size(), 3u);
}

TEST_F(Bags, GapsInThePosesCostTheirScans) {
  const Messages messages = {cloud(kRos1, 100, {{1, 0, 0}}), cloud(kRos1, 103, {{1, 0, 0}}),
                             odometry(kRos1, {100, "odom", "lidar", {0, 0, 0}}),
                             odometry(kRos1, {106, "odom", "lidar", {0, 0, 0}})};
  EXPECT_NE(
      failure_of(messages).find("no pose for the scan at 103 s: /odom has poses at 100 and 106 "
                                "s: allowed: a gap of input.pose_gap_s = 1"),
      std::string::npos)
      << failure_of(messages);
  options_.keep_going = true;
  EXPECT_EQ(frames_of(messages).size(), 1u);
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"no pose", 1}}));
}

TEST_F(Bags, BrokenCloudsCostThemselves) {
  options_.input.poses = PoseSource::kStill;
  const auto expect = [&](TestMessage broken, const std::string& why) {
    options_.keep_going = false;
    const Messages messages = {broken, cloud(kRos1, 101, {{1, 0, 0}})};
    EXPECT_NE(failure_of(messages).find(why), std::string::npos) << failure_of(messages);
    options_.keep_going = true;
    EXPECT_EQ(frames_of(messages).size(), 1u);
    EXPECT_EQ(counts_.skipped(), 1);
  };
  TestMessage message = cloud(kRos1, 100, {{1, 0, 0}, {2, 0, 0}});
  message.bytes.resize(message.bytes.size() - 10);
  expect(message, "the bytes end too early");
  expect(cloud(kRos1, 100, {{1, 0, 0}}, {4}), "field x of type 4: allowed: 7 (32-bit float) or 8");
  expect(cloud(kRos1, 0, {{1, 0, 0}}), "the scan's stamp is 0: allowed: a time");
  expect({{"/points", "sensor_msgs/PointCloud2", kRos1},
          100,
          MessageWriter(kRos1)
              .header(100, "lidar")
              .add(1U)
              .add(9U)
              .add(0U)
              .add(std::uint8_t{0})
              .add(16U)
              .add(144U)
              .bytes("")
              .str()},
         "no field x: allowed: x, y and z");
}

TEST_F(Bags, DamageEndsTheBag) {
  const std::string bag = ros1_bag(drive(kRos1), "lz4", 2);
  for (const std::size_t lost : {1U, 30U, 200U}) {
    options_.keep_going = false;
    EXPECT_THROW(frames_of(write("a.bag", bag.substr(0, bag.size() - lost))), ldm::InvalidInput);
    options_.keep_going = true;
    EXPECT_GE(frames_of(write("a.bag", bag.substr(0, bag.size() - lost))).size(), 1u);
    EXPECT_EQ(counts_.frames_skipped.count("broken log"), 1u);
  }
  EXPECT_THROW(frames_of(write("a.bag", "#ROSBAG V1.2\n")), ldm::InvalidInput);
  EXPECT_THROW(frames_of(write("a.mcap", "MCAP")), ldm::InvalidInput);
  EXPECT_THROW(frames_of(write("a.db3", "SQLite")), ldm::InvalidInput);
  EXPECT_THROW(frames_of(write("b.bag", ros1_bag({}))), ldm::InvalidInput);
}

TEST_F(Bags, LivoxesOwnMessage) {
  options_.input.poses = PoseSource::kStill;
  for (const MessageEncoding encoding : {kRos1, kCdr}) {
    const TestMessage message = {
        {"/livox/lidar", "livox_ros_driver2/CustomMsg", encoding},
        100,
        livox_bytes(encoding, 100, "livox", {{1, 2, 3, 0}, {4, 5, 6, 9e7}})};
    const fs::path bag = encoding == kRos1 ? write("a.bag", ros1_bag({message}))
                                           : write("a.mcap", mcap_bag({message}, "lz4"));
    EXPECT_EQ(frames_of(bag).at(0).scan.points, (std::vector<ldm::Point>{{1, 2, 3}, {4, 5, 6}}));
  }
}

/// A sensor that drives at 10 m/s and turns by 1 rad/s sees a wall at x = 30 m for 0.1 s: the
/// points lie in the plane where the sensor was at the stamp.
TEST_F(Bags, AWallScannedInMotionIsFlat) {
  const double stamp = 100.05;
  const auto sensor = [&](double time) {
    const double t = time - stamp;
    return ldm::Pose{yaw(0.3 + t).toRotationMatrix(), {10 * t, 2 * t, 1}};
  };
  const auto scan_wall = [&](double unit, double zero) {
    std::vector<TestPoint> points;
    for (int k = 0; k < 200; ++k) {
      const double time = stamp + 0.0005 * k - 0.05;
      const ldm::Pose pose = sensor(time);
      const Eigen::Vector3d p(30, -10 + 0.1 * k, 0.02 * k);
      const Eigen::Vector3d seen = pose.rotation.transpose() * (p - pose.translation);
      points.push_back({seen.x(), seen.y(), seen.z(), (time - zero) / unit});
    }
    return points;
  };
  Messages poses;
  for (int k = 0; k < 40; ++k) {
    const double time = stamp - 0.1 + 0.005 * k;
    const ldm::Pose pose = sensor(time);
    poses.push_back(odometry(
        kRos1, {time, "odom", "lidar", pose.translation, Eigen::Quaterniond(pose.rotation)}));
  }
  const auto worst = [&](const Messages& scans) {
    Messages messages = poses;
    messages.insert(messages.begin(), scans.begin(), scans.end());
    const ldm::Scan scan = frames_of(messages).at(0).scan;
    double error = 0;
    for (std::size_t k = 0; k < scan.points.size(); ++k) {
      const Eigen::Vector3d p = scan.T_world_sensor * scan.points[k].cast<double>();
      error = std::max(error, (p - Eigen::Vector3d(30, -10 + 0.1 * static_cast<double>(k),
                                                   0.02 * static_cast<double>(k)))
                                  .norm());
    }
    return error;
  };
  const CloudLayout seconds{7, "time", 7}, clock{7, "timestamp", 8};
  EXPECT_LT(worst({cloud(kRos1, stamp, scan_wall(1, stamp), seconds)}), 0.001);
  EXPECT_LT(worst({cloud(kRos1, stamp, scan_wall(1e-6, stamp), {7, "time", 8})}), 0.001);
  EXPECT_LT(worst({cloud(kRos1, stamp, scan_wall(1, 0), clock)}), 0.001);
  EXPECT_LT(worst({cloud(kRos1, stamp, scan_wall(1e-9, 0), clock)}), 0.001);
  options_.input.deskew = false;
  EXPECT_GT(worst({cloud(kRos1, stamp, scan_wall(1, stamp), seconds)}), 1.0);
  options_.input.deskew = true;
  // Times of another clock.
  EXPECT_NE(
      failure_of({cloud(kRos1, stamp, scan_wall(1, -5000), seconds), poses[0]})
          .find("times of points in the field time lie more than 2 s from the stamp: allowed: "
                "--set input.deskew=false"),
      std::string::npos);
}

TEST_F(Bags, LineBreaksInNamesAreNoneInMessages) {
  Messages messages = drive(kRos1);
  messages.push_back(cloud(kRos1, 100, {{1, 2, 3}}, {}, "/rear\npoints"));
  EXPECT_NE(failure_of(messages).find("/rear?points"), std::string::npos);
  options_.input.poses = PoseSource::kLog;
  EXPECT_NE(failure_of({cloud(kRos1, 100, {{1, 2, 3}}, {}, "/points", "li\ndar")})
                .find("has no poses of li?dar"),
            std::string::npos);
}

TEST_F(Bags, MemoryDoesNotGrowWithTheBag) {
  const fs::path bag = write("a.bag", ros1_bag(drive(kRos1, 300), "lz4"));
  const auto source = open_recording(bag, options_);
  std::vector<std::size_t> heap;
  heap.reserve(300);
  for (Frame frame; source->next(frame);) heap.push_back(mallinfo2().uordblks);
  ASSERT_EQ(heap.size(), 300u);
  EXPECT_LE(heap[298], heap[50] + 8192);
}

}  // namespace
}  // namespace datasets
