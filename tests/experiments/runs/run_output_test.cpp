/// What `ldm run` writes beside its summary, from outside: docs/run-output.md.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/runs/run_folder.h"
#include "tests/experiments/program.h"

namespace experiments {
namespace {

constexpr char kSmall[] = " --set particles.count=2000 --set execution.threads=1";

class RunOutput : public Program {
 protected:
  /// Six frames of scenario3 in the folder `o`, with the maps of frames 2 and 5.
  void run_small(const std::string& more = "") {
    const Result result =
        ldm("run ldm scenario3 -o o --frames 6 --save-frames 2,5" + std::string(kSmall) + more);
    ASSERT_EQ(result.code, 0) << result.error;
  }
  std::vector<std::vector<std::string>> rows(const std::string& file) {
    std::vector<std::vector<std::string>> all;
    std::istringstream text(folder_.read(file));
    for (std::string line; std::getline(text, line);) {
      all.emplace_back();
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) all.back().push_back(cell);
    }
    return all;
  }
  std::size_t number(const std::string& text) { return std::stoul(text); }
};

TEST_F(RunOutput, FramesAndClustersFitTogether) {
  run_small();
  const auto frames = rows("o/frames.csv");
  ASSERT_EQ(frames.size(), 7u);
  std::size_t clusters = 0, dynamic = 0, points = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    ASSERT_EQ(frames[i].size(), 14u);
    EXPECT_EQ(frames[i][0], std::to_string(i - 1));
    EXPECT_EQ(frames[i][8], "4.8000");
    points += number(frames[i][11]);
    clusters += number(frames[i][12]);
    dynamic += number(frames[i][13]);
  }
  const auto table = rows("o/clusters.csv");
  EXPECT_EQ(table.size() - 1, clusters);
  std::size_t dynamic_rows = 0, points_in_clusters = 0;
  for (std::size_t i = 1; i < table.size(); ++i) {
    ASSERT_EQ(table[i].size(), 20u);
    EXPECT_GE(number(table[i][3]), 1u);
    points_in_clusters += number(table[i][18]);
    dynamic_rows += number(table[i][19]);
  }
  EXPECT_EQ(dynamic_rows, dynamic);
  EXPECT_GT(points_in_clusters, 100u);
  EXPECT_LE(points_in_clusters, points);
}

TEST_F(RunOutput, ReadsBack) {
  run_small();
  const auto frames = read_run_frames(folder_.path() / "o");
  ASSERT_EQ(frames.size(), 6u);
  std::size_t clusters = 0;
  for (const auto& [number, frame] : frames) clusters += frame.clusters.size();
  EXPECT_EQ(clusters + 1, rows("o/clusters.csv").size());
  EXPECT_TRUE(frames.at(5).map.sizes().isApproxToConstant(4.8));
  EXPECT_DOUBLE_EQ(frames.at(5).time, 0.5);
}

/// The vertices of a PLY file, as `ldm run` writes them.
struct Vertex {
  float x, y, z;
  unsigned char red, green, blue;
  float occupancy;
  std::int32_t track;
};
std::vector<Vertex> vertices_of(const std::string& ply) {
  constexpr std::size_t kBytes = 3 * 4 + 3 + 4 + 4;
  const std::size_t begin = ply.find("end_header\n") + 11;
  std::vector<Vertex> vertices;
  for (std::size_t at = begin; at < ply.size(); at += kBytes) {
    Vertex v{};
    std::memcpy(&v.x, &ply[at], 12);
    std::memcpy(&v.red, &ply[at + 12], 3);
    std::memcpy(&v.occupancy, &ply[at + 15], 4);
    std::memcpy(&v.track, &ply[at + 19], 4);
    vertices.push_back(v);
  }
  return vertices;
}

TEST_F(RunOutput, ChosenFramesBecomeFilesOfVoxels) {
  run_small();
  const std::string header = folder_.read("o/maps/frame_000005.occupied.ply");
  EXPECT_EQ(header.rfind("ply\nformat binary_little_endian 1.0\nelement vertex ", 0), 0u);
  const std::vector<Vertex> occupied = vertices_of(header);
  const std::vector<Vertex> free = vertices_of(folder_.read("o/maps/frame_000005.free.ply"));
  EXPECT_NE(header.find("element vertex " + std::to_string(occupied.size()) + "\n"),
            std::string::npos);
  ASSERT_GT(occupied.size(), 50u);
  ASSERT_GT(free.size(), 1000u);

  for (const std::vector<Vertex>* vertices : {&occupied, &free}) {
    for (const Vertex& v : *vertices) EXPECT_EQ(v.occupancy > 0.5F, vertices == &occupied);
  }
  EXPECT_EQ(folder_.read("o/maps/frame_000005.bt").rfind("# Octomap OcTree binary file", 0), 0u);
  EXPECT_TRUE(exists("o/maps/frame_000002.bt"));
  EXPECT_FALSE(exists("o/maps/frame_000003.bt"));
}

TEST_F(RunOutput, VoxelsOfAPlyAreColouredByTheirTrack) {
  run_small(" --save-as ply");
  EXPECT_FALSE(exists("o/maps/frame_000005.bt"));
  std::map<std::int32_t, std::array<unsigned char, 3>> colour_of;
  for (const Vertex& v : vertices_of(folder_.read("o/maps/frame_000005.occupied.ply"))) {
    const std::array<unsigned char, 3> colour{v.red, v.green, v.blue};
    EXPECT_EQ(colour_of.try_emplace(v.track, colour).first->second, colour);
  }
  colour_of.erase(0);  // in no cluster
  std::map<std::int32_t, std::size_t> voxels;
  for (const auto& row : rows("o/clusters.csv")) {
    if (row[0] == "5") voxels[static_cast<std::int32_t>(number(row[3]))] = number(row[17]);
  }
  EXPECT_EQ(colour_of.size(), voxels.size());
  for (const auto& [track, colour] : colour_of) EXPECT_TRUE(voxels.contains(track)) << track;
}

TEST_F(RunOutput, RefusesBadRequestsForMaps) {
  expect_bad("run ldm scenario1 -o o --save-frames 1 --save-as obj",
             "--save-as obj: allowed: ply, bt");
  expect_bad("run ldm scenario1 -o o --save-frames -1",
             "--save-frames: -1: allowed: a number from 0 on");
  expect_bad("run ldm scenario1 -o o --rate 0", "--rate: 0: allowed: a number above 0");
  EXPECT_FALSE(exists("o"));
  expect_bad("run current_scan scenario1 -o o --frames 3 --save-frames 1,7",
             "--save-frames 7: allowed: frames of the run");
  EXPECT_TRUE(exists("o/maps/frame_000001.bt"));  // what there was is kept
  EXPECT_TRUE(exists("o/summary.json"));
}

TEST_F(RunOutput, ARunAtTheLogsSpeedTellsWhatCameLate) {
  const Result result = ldm("run current_scan scenario1 -o o --frames 5 --rate 2");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.out.rfind("played at 2 times the log's speed: ", 0), 0u) << result.out;
  EXPECT_NE(folder_.read("o/summary.json").find("\"real_time\": {\"rate\":2.0,\"late_frames\":"),
            std::string::npos);
}

TEST_F(RunOutput, FramesLateForAFastLogAreCounted) {
  const Result result = ldm("run ldm scenario1 -o o --frames 8 --rate 1e6" + std::string(kSmall));
  EXPECT_EQ(result.code, 0) << result.error;
  // The first frame is never late; the second may take less than kTolerance to come.
  const std::size_t at = result.out.find(" frames came late");
  ASSERT_NE(at, std::string::npos) << result.out;
  const char count = result.out[at - 1];
  EXPECT_TRUE(count >= '1' && count <= '7') << result.out;
  EXPECT_NE(folder_.read("o/summary.json").find("\"late_frames\":" + std::string(1, count) + ","),
            std::string::npos);
}

TEST_F(RunOutput, AnInterruptedRunKeepsItsFrames) {
  for (const std::string signal : {"INT", "HUP"}) {
    std::filesystem::remove_all(folder_.path() / "o");
    const Result result = run("sh", "-c '" + std::string(LDM_PROGRAM) +
                                        " run current_scan scenario1 -o o --rate 1 & "
                                        "while kill -0 $! && [ ! -d o ]; do sleep 0.02; done; "
                                        "sleep 0.5; kill -" +
                                        signal + " $!; wait $!'");
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.error.rfind("ldm: interrupted after ", 0), 0u) << result.error;
    EXPECT_EQ(lines(result.error), 1u);
    const std::string summary = folder_.read("o/summary.json");
    EXPECT_NE(summary.find("\"interrupted\": true"), std::string::npos) << summary;
    const std::size_t frames = rows("o/frames.csv").size() - 1;
    EXPECT_LT(frames, 30u);
    EXPECT_NE(summary.find("\"frames\": " + std::to_string(frames) + ","), std::string::npos);
  }
}

}  // namespace
}  // namespace experiments
