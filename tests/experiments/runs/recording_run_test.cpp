/// `ldm run` on recordings, from outside: presets, input.* parameters, broken frames.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "experiments/runs/run_folder.h"
#include "tests/experiments/program.h"

namespace experiments {
namespace {

constexpr char kFew[] = " --set particles.count=20000 --set execution.threads=1 ";

/// A KITTI drive of four scans along a level street with a wall to the left and a pole.
class RecordingRun : public Program {
 protected:
  void SetUp() override {
    std::string times, poses;
    for (int k = 0; k < 4; ++k) {
      write_scan(k);
      times += std::to_string(0.1 * k) + "\n";
      poses += "1 0 0 " + std::to_string(0.8 * k) + " 0 1 0 0 0 0 1 0\n";
    }
    folder_.write("drive/times.txt", times);
    folder_.write("drive/poses.txt", poses);
  }

  void write_scan(int k) const {
    std::vector<float> points;
    const auto add = [&](double x, double y, double z) {
      for (const double n : {x - 0.8 * k, y, z, 0.0}) points.push_back(static_cast<float>(n));
    };
    for (double x = -20; x < 20; x += 0.4) {
      for (double y = -10; y < 10; y += 0.4) add(x, y, -1.7);
    }
    for (double x = -20; x < 20; x += 0.2) {
      for (double z = -1.4; z < 1; z += 0.2) add(x, 10, z);
    }
    for (double z = -1.6; z < 0; z += 0.1) add(8, -3, z);
    char name[32];
    std::snprintf(name, sizeof name, "drive/velodyne/%06d.bin", k);
    folder_.write(name, std::string(reinterpret_cast<const char*>(points.data()),
                                    points.size() * sizeof(float)));
  }

  std::string summary() const { return folder_.read("o/summary.json"); }
  void expect_in_summary(const std::string& text) const {
    EXPECT_NE(summary().find(text), std::string::npos) << text;
  }
};

TEST_F(RecordingRun, ADriveRunsWithAPresetAlone) {
  const Result result = ldm("run ldm drive -c road -o o --set execution.threads=1");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  expect_in_summary("\"frames\": 4");
  expect_in_summary("\"map.voxels\":[128,128,32]");
  expect_in_summary("\"input.ground.removal\":\"grid\"");
  expect_in_summary("\"nearer than input.min_range_m\":");
  expect_in_summary("\"on the ground\":");
  EXPECT_EQ(summary().find("scores"), std::string::npos);
  // The wall and the pole, and no street below them.
  const std::string clusters = folder_.read("o/clusters.csv");
  const std::size_t last = clusters.find("\n3,");
  ASSERT_NE(last, std::string::npos);
  EXPECT_EQ(lines(clusters.substr(last + 1)), 2u) << clusters.substr(last + 1);
}

TEST_F(RecordingRun, SettingsAreStrongerThanThePreset) {
  const Result result =
      ldm("run ldm drive -c road -o o --set map.resolution_m=0.5 --set "
          "map.voxels=64,64,16 --set input.ground.removal=none" +
          std::string(kFew));
  EXPECT_EQ(result.code, 0) << result.error;
  expect_in_summary("\"map.voxels\":[64,64,16]");
  expect_in_summary("\"input.ground.removal\":\"none\"");
  EXPECT_EQ(summary().find("on the ground"), std::string::npos);
}

TEST_F(RecordingRun, APresetSaysNothingToMethodsThatDoNotAsk) {
  const Result result = ldm("run current_scan drive -c road -o o");
  EXPECT_EQ(result.code, 0) << result.error;
  folder_.write("mine.toml", "[particles]\ncount = 500\n");
  expect_bad("run current_scan drive -c mine.toml -o o", "parameters that current_scan uses");
}

TEST_F(RecordingRun, EveryPresetRuns) {
  for (const char* preset : {"uav", "road", "indoor"}) {
    const Result result = ldm("run ldm drive -o o -c " + std::string(preset) + kFew);
    EXPECT_EQ(result.code, 0) << preset << ": " << result.error;
  }
  EXPECT_EQ(ldm("run ldm scenario1 -c uav --frames 2 -o o" + std::string(kFew)).code, 0);
  expect_bad("run ldm drive -c moon -o o", "unknown preset moon: allowed: a .toml file, indoor");
}

TEST_F(RecordingRun, ThePaperValuesAreThePresetUav) {
  ASSERT_EQ(ldm("run ldm scenario1 --frames 2 -o plain" + std::string(kFew)).code, 0);
  ASSERT_EQ(ldm("run ldm scenario1 --frames 2 -c uav -o o" + std::string(kFew)).code, 0);
  EXPECT_EQ(folder_.read("o/clusters.csv"), folder_.read("plain/clusters.csv"));
}

TEST_F(RecordingRun, BrokenFramesEndTheRunOrAreCounted) {
  const std::filesystem::path scan = folder_.path() / "drive/velodyne/000002.bin";
  std::filesystem::resize_file(scan, 1000);
  const std::string run = "run current_scan drive -c road -o o";
  expect_bad(run, "drive/velodyne/000002.bin: byte 1000: the file ends");
  EXPECT_FALSE(exists("o/summary.json"));
  const Result result = ldm(run + " --keep-going");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.error, "ldm: 1 frames skipped: 1 broken scan\n");
  expect_in_summary("\"frames\": 3");
  expect_in_summary("\"frames_skipped\":{\"broken scan\":1}");
  // The frames keep their numbers in the recording.
  const std::string timing = folder_.read("o/timing.csv");
  EXPECT_NE(timing.find("\n3,"), std::string::npos) << timing;
  EXPECT_EQ(timing.find("\n2,"), std::string::npos) << timing;
  folder_.write("drive/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  for (const char* more : {"", " --keep-going"}) {
    expect_bad(run + more, "drive/poses.txt: 1 lines: allowed: 4, as many as drive/times.txt has");
  }
}

TEST_F(RecordingRun, WithoutAUsedFrameItFails) {
  for (int k = 0; k < 4; ++k) {
    std::filesystem::resize_file(
        folder_.path() / ("drive/velodyne/00000" + std::to_string(k) + ".bin"), 10);
  }
  const Result result = ldm("run current_scan drive -o o --keep-going");
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.error,
            "ldm: 4 frames skipped: 4 broken scan\nldm: drive: no frame could be used\n");
}

TEST_F(RecordingRun, LossesAreTold) {
  const Result result = ldm("run current_scan drive -o o --set input.min_range_m=500");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.error.rfind("ldm: no point was used: ", 0), 0u) << result.error;
  EXPECT_EQ(lines(result.error), 1u);
}

/// Positions of floats would come in steps of half a metre.
TEST_F(RecordingRun, CoordinatesOfACountryKeepTheirDecimals) {
  const std::string run = "run ldm drive -c road --set execution.threads=1 --save-frames 3 -o ";
  ASSERT_EQ(ldm(run + "near").code, 0);
  std::string poses;
  for (int k = 0; k < 4; ++k) {
    poses += "1 0 0 " + std::to_string(600000 + 0.8 * k) + " 0 1 0 5400000 0 0 1 0\n";
  }
  folder_.write("drive/poses.txt", poses);
  const Result result = ldm(run + "far");
  EXPECT_EQ(result.code, 0) << result.error;
  const auto centroid = [&](const std::string& folder) {
    const auto frames = read_run_frames(folder_.path() / folder);
    return frames.at(3).clusters.at(0).position;
  };
  const Eigen::Vector3d difference = centroid("far") - centroid("near");
  EXPECT_NEAR(difference.x(), 600000, 1.5e-4);
  EXPECT_NEAR(difference.y(), 5400000, 1.5e-4);
  EXPECT_NE(folder_.read("far/summary.json").find("\"origin_m\": [600000.0,5400000.0,0.0]"),
            std::string::npos);
  const std::string ply = folder_.read("far/maps/frame_000003.occupied.ply");
  EXPECT_NE(ply.find("\ncomment origin_m 600000 5400000 0\n"), std::string::npos);
  EXPECT_EQ(ply.substr(ply.find("end_header")).size(),
            folder_.read("near/maps/frame_000003.occupied.ply").size() -
                folder_.read("near/maps/frame_000003.occupied.ply").find("end_header"));
  EXPECT_NE(folder_.read("far/maps/frame_000003.bt").find("\n# origin_m 600000 5400000 0\n"),
            std::string::npos);
}

TEST_F(RecordingRun, AMapThatCannotBeWrittenCostsNoTables) {
  folder_.write("o/maps", "a file in the folder's place");
  const Result result = ldm("run current_scan drive -o o --save-frames 2");
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.error.find("o/maps"), std::string::npos) << result.error;
  EXPECT_EQ(lines(folder_.read("o/frames.csv")), 5u);
}

TEST_F(RecordingRun, AFolderUsedAgainHoldsTheLastRunAlone) {
  ASSERT_EQ(ldm("run current_scan drive -o o --save-frames 2,3").code, 0);
  folder_.write("o/score.json", "{}");
  folder_.write("o/notes.txt", "mine");
  folder_.write("o/maps/mine.ply", "mine");
  ASSERT_EQ(ldm("run current_scan drive -o o --frames 2 --save-frames 1 --save-as ply").code, 0);
  EXPECT_FALSE(exists("o/score.json"));
  EXPECT_FALSE(exists("o/maps/frame_000002.bt"));
  EXPECT_TRUE(exists("o/maps/frame_000001.free.ply"));
  std::filesystem::resize_file(folder_.path() / "drive/velodyne/000002.bin", 10);
  EXPECT_EQ(ldm("run current_scan drive -o o").code, 2);
  for (const char* name : {"clusters.csv", "frames.csv", "timing.csv", "summary.json"}) {
    EXPECT_FALSE(exists("o/" + std::string(name))) << name;
  }
  EXPECT_FALSE(exists("o/maps/frame_000001.free.ply"));
  EXPECT_TRUE(exists("o/maps/mine.ply"));
  EXPECT_TRUE(exists("o/notes.txt"));
}

TEST_F(RecordingRun, FoldersWithNamesInLatin1) {
  std::filesystem::rename(folder_.path() / "drive", folder_.path() /
                                                        "Stra\xdf"
                                                        "e");
  EXPECT_EQ(ldm("run current_scan './Stra\xdf"
                "e' -o o")
                .code,
            0);
  expect_in_summary(
      "\"input\": \"./Stra\xef\xbf\xbd"
      "e\"");
}

TEST_F(RecordingRun, OptionsWithoutAnEffectAreRefused) {
  expect_bad("run ldm scenario1 -o o --set input.min_range_m=2",
             "--set: input.min_range_m = 2: allowed: with a recording (KITTI, PCD, MRPT, bags)");
  expect_bad("run ldm scenario1 -o o -c road", "road.toml:");
  expect_bad("run ldm scenario1 -o o --keep-going", "--keep-going: allowed: with a log");
  expect_bad("run ldm scenario1 -o o --poses p.txt", "--poses p.txt: allowed: with a recording");
  expect_bad("run ldm scenario1 -o o --times t.txt", "--times t.txt: allowed: with a recording");
  expect_bad("run ldm scenario1 -o o --time-unit ms", "--time-unit ms: allowed: with a recording");
  expect_bad("run ldm drive -o o --time-unit h", "--time-unit h: allowed: s, ms, us, ns");
  expect_bad("run ldm scenario1 -o o --points /scan", "--points /scan: allowed: with a bag");
  expect_bad("run ldm drive -o o --sensor-frame os", "--sensor-frame os: allowed: with a bag");
  expect_bad("run ldm drive --seed 3 -o o", "--seed 3: allowed: with a scenario");
  ASSERT_EQ(ldm("simulate scenario1 --frames 2 -o a.rawlog").code, 0);
  expect_bad("run ldm a.rawlog -o o --set input.ground.removal=plane", "allowed: with a recording");
  expect_bad("run ldm a.rawlog -o o --times t.txt", "--times t.txt: allowed: with a recording");
}

TEST_F(RecordingRun, InfoTellsWhatIsInARecording) {
  std::filesystem::resize_file(folder_.path() / "drive/velodyne/000002.bin", 10);
  const Result result = ldm("info drive --set input.max_range_m=15");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.out.rfind("format  kitti\nscans   3 that can be used, 6.7 Hz\n"
                             "times   0.000 to 0.300 s (0.3 s)\npoints  ",
                             0),
            0u)
      << result.out;
  EXPECT_NE(result.out.find("\nsensor  from (0.00, 0.00, 0.00) to (2.40, 0.00, 0.00) m\n"
                            "lost    1 frames skipped: 1 broken scan\n"),
            std::string::npos)
      << result.out;
  expect_bad("info driev", "driev: no such recording or scenario");
}

TEST_F(RecordingRun, BadInputsNameWhatIsAllowed) {
  expect_bad(
      "run ldm drive --format las -o o",
      "--format las: allowed: ldm-rawlog, mrpt-rawlog, kitti, kitti-raw, bin, pcd, bag, pcap");
  expect_bad("run ldm drive --format pcd -o o", "drive: has no scans (*.pcd)");
  expect_bad("run ldm no/drive -o o", "no/drive: cannot be read: no such file");
  expect_bad("run ldm drive -o o --set input.ground.removal=flat", "allowed: none, plane, grid");
  expect_bad("run ldm drive -o o --set input.min_range_m=9 --set input.max_range_m=8",
             "input.min_range_m = 9: allowed: at most input.max_range_m = 8");
  expect_bad("run ldm drive -o o --set input.colour=red", "unknown parameter input.colour");
  std::filesystem::create_directory(folder_.path() / "empty");
  expect_bad("run ldm empty -c road -o o", "empty: no recording: allowed: a KITTI folder");
  expect_bad("run ldm driev -c road -o o", "driev: no such recording or scenario: allowed: a file");
  expect_bad("run ldm ./empty -o o", "./empty: no recording: allowed: a KITTI folder");
}

TEST_F(RecordingRun, APackagedSweepRunsIndoors) {
  const std::string log =
      "run ldm /usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog -o o -c indoor";
  expect_bad(log, "has no CObservationRobotPose: allowed: --set input.poses=still");
  const Result result = ldm(log + " --set input.poses=still" + kFew);
  EXPECT_EQ(result.code, 0) << result.error;
  expect_in_summary("\"frames\": 1");
}

TEST_F(RecordingRun, ParametersListThoseOfRecordings) {
  for (const char* arguments : {"parameters", "parameters octomap"}) {
    EXPECT_NE(ldm(arguments).out.find("input.ground.removal"), std::string::npos);
  }
}

TEST_F(RecordingRun, ADriveCanBeDrawn) {
  const Result result = ldm("render ldm drive -c road --frame 2 -o map.png" + std::string(kFew));
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_TRUE(exists("map.png"));
}

}  // namespace
}  // namespace experiments
