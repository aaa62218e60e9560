/// `ldm info` of a bag: topics, times, frames, and what is taken or why nothing is.
#include "datasets/recording/recording_info.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/datasets/recording/formats/ros/bag_writer.h"
#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

class RecordingInfo : public RecordingFolder {};

TEST_F(RecordingInfo, OfABag) {
  constexpr MessageEncoding kCdr = MessageEncoding::kCdr;
  std::vector<TestMessage> messages;
  for (int k = 0; k < 11; ++k) {
    const double time = 100 + 0.1 * k;
    messages.push_back({{"/points", "sensor_msgs/PointCloud2", kCdr},
                        time,
                        cloud_bytes(kCdr, time, "lidar", {{1, 2, 3}})});
  }
  messages.push_back({{"/odom", "nav_msgs/Odometry", kCdr},
                      100,
                      odometry_bytes(kCdr, {100, "map", "lidar", {0, 0, 0}})});
  const fs::path bag = write("a.mcap", mcap_bag(messages, "zstd"));
  const auto described = [&] {
    std::ostringstream out;
    describe_recording(bag, options_, out);
    return out.str();
  };
  const std::string contents =
      "format  bag\n"
      "topic   /points: sensor_msgs/PointCloud2, 11 messages, 10.0 Hz, in lidar\n"
      "topic   /odom: nav_msgs/Odometry, 1 messages, in map of lidar\n"
      "times   100.000 to 101.000 s (1.0 s)\n";
  EXPECT_EQ(described(),
            contents + "taken   scans of /points in lidar, poses of /odom, the sensor's\n");
  options_.points = "/front";
  EXPECT_EQ(described(), contents + "taken   nothing: " + bag.string() +
                             ": --points /front: allowed: /points\n");
}

}  // namespace
}  // namespace datasets
