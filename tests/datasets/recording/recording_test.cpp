/// Recordings: the format is recognised, and logs of our own are taken as they are.
#include "datasets/recording/recording.h"

#include <gtest/gtest.h>

#include "tests/datasets/rawlog/rawlog_recording.h"
#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

class Recordings : public RecordingFolder {};

TEST_F(Recordings, TheFormatIsRecognised) {
  EXPECT_EQ(recognised_format(folder_), std::nullopt);
  EXPECT_EQ(recognised_format(folder_ / "missing"), std::nullopt);
  write("a/velodyne/000000.bin", "");
  EXPECT_EQ(recognised_format(folder_ / "a"), RecordingFormat::kKitti);
  write("b/1.pcd", "");
  write("k/velodyne_points/data/0.bin", "");
  EXPECT_EQ(recognised_format(folder_ / "k"), RecordingFormat::kKittiRaw);
  write("n/1.BIN", "");
  EXPECT_EQ(recognised_format(folder_ / "n"), RecordingFormat::kBin);
  for (const char* name : {"i.pcap", "j.PCAPNG"}) {
    EXPECT_EQ(recognised_format(write(name, "")), RecordingFormat::kPcap) << name;
  }
  EXPECT_EQ(recognised_format(folder_ / "b"), RecordingFormat::kPcd);
  const fs::path log = write("c.rawlog", "");
  EXPECT_EQ(recognised_format(log), RecordingFormat::kMrptRawlog);
  write("c.log.toml", "");
  EXPECT_EQ(recognised_format(log), RecordingFormat::kLdmRawlog);
  for (const char* name : {"d.bag", "e.mcap", "f.db3", "split/g_0.mcap"}) {
    EXPECT_EQ(recognised_format(write(name, "")), RecordingFormat::kBag) << name;
  }
  EXPECT_EQ(recognised_format(folder_ / "split"), RecordingFormat::kBag);
  EXPECT_EQ(recognised_format(write("h.las", "")), std::nullopt);
}

TEST_F(Recordings, WhatIsNoRecordingIsRefused) {
  EXPECT_NE(failure().find(folder_.string() + ": no recording: allowed: a KITTI folder"),
            std::string::npos);
  folder_ /= "missing";
  EXPECT_EQ(failure(), folder_.string() + ": cannot be read: no such file");
  folder_ = folder_.parent_path();
}

TEST_F(Recordings, AFormatMayBeGiven) {
  write_drive(1);
  write("1.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n7 8 9\n");
  EXPECT_EQ(frames().at(0).scan.points.at(0), ldm::Point(10, 1, 2));
  options_.format = RecordingFormat::kPcd;
  EXPECT_EQ(frames().at(0).scan.points.at(0), ldm::Point(7, 8, 9));
}

TEST_F(Recordings, CoordinatesOfACountryBecomeRelativeToAnOrigin) {
  write_drive(2);
  write("poses.txt",
        "1 0 0 500000.25 0 1 0 -5400000.375 0 0 1 30\n"
        "1 0 0 500001.25 0 1 0 -5400000.375 0 0 1 30\n");
  options_.origin_step = 0.5;
  const std::vector<Frame> all = frames();
  ASSERT_EQ(all.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(all[k].origin, Eigen::Vector3d(500000.5, -5400000.5, 0));
    const Eigen::Vector3d place(-0.25 + static_cast<double>(k), 0.125, 30);
    EXPECT_EQ(all[k].scan.T_world_uav.translation, place);
    EXPECT_EQ(all[k].scan.T_world_sensor.translation, place);
  }
  EXPECT_EQ(origin_text(all[0]), "origin_m 500000.5 -5400000.5 0");
  write_drive(2);
  EXPECT_EQ(origin_text(frames().at(0)), "");
}

TEST(InputCountsTest, TellLossesInALineEach) {
  InputCounts counts;
  EXPECT_TRUE(counts.losses(5, 0).empty());
  counts.points_dropped = {{"not finite", 3}, {"farther than input.max_range_m", 7}};
  counts.other = {{InputCounts::kNoGround, 4}};
  EXPECT_TRUE(counts.losses(5, 10).empty());
  counts.other_sensors = {{"CObservationPointCloud `rear`", 9}};
  counts.frames_skipped = {{"no pose", 2}};
  EXPECT_EQ(
      counts.losses(4, 0),
      (std::vector<std::string>{"2 frames skipped: 2 no pose",
                                "9 scans of another sensor left out: CObservationPointCloud `rear`",
                                "no point was used: 7 farther than input.max_range_m, 3 not finite",
                                "no ground was found in any frame: all points were used"}));
}

class OwnLog : public Rawlog {
 protected:
  std::size_t read(RecordingOptions options, InputCounts& counts) {
    std::size_t count = 0;
    const auto source = open_recording(rawlog(), options);
    for (Frame frame; source->next(frame); ++count) {
    }
    counts = source->counts();
    return count;
  }
};

TEST_F(OwnLog, IsTakenAsItIs) {
  RecordingOptions options;
  options.input.max_range = 1;
  InputCounts counts;
  EXPECT_EQ(read(options, counts), 5u);
  EXPECT_TRUE(counts.points_dropped.empty());
  Frame frame;
  open_recording(rawlog(), options)->next(frame);
  EXPECT_EQ(frame.scan.points, recording_.frames[0].scan.points);
  EXPECT_TRUE(frame.truth);
}

TEST_F(OwnLog, EndsAtDamageIfToldToKeepGoing) {
  fs::resize_file(rawlog(), fs::file_size(rawlog()) / 2);
  RecordingOptions options;
  InputCounts counts;
  EXPECT_THROW(read(options, counts), ldm::InvalidInput);
  options.keep_going = true;
  const std::size_t frames = read(options, counts);
  EXPECT_LT(frames, 5u);
  EXPECT_EQ(counts.skipped(), 5 - static_cast<std::int64_t>(frames));
}

}  // namespace
}  // namespace datasets
