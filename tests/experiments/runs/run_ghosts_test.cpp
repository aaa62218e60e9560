#include "experiments/runs/run_ghosts.h"

#include <gtest/gtest.h>

#include <fstream>

#include "experiments/runs/ply_file.h"
#include "experiments/runs/saved_maps.h"
#include "tests/temporary_folder.h"
#include "tests/text_file.h"

namespace experiments {
namespace {

/// Three frames of a map of 10^3 voxels of 0.5 m, and a box of one voxel that moves along x. The
/// world begins at (1000, 0, 0).
class GhostsOfARun : public testing::Test {
 protected:
  GhostsOfARun() {
    folder_.write("summary.json", R"({"parameters": {"map.resolution_m": 0.5}})");
    for (const int x : {2, 4, 6}) {
      const auto number = static_cast<std::int64_t>(run_.size());
      RunFrame& frame = run_[number];
      frame.time = 0.1 * static_cast<double>(number);
      frame.map = {Eigen::Vector3d(1000, 0, 0), Eigen::Vector3d(1005, 5, 5)};
      truth_[number].objects = {{.id = 1,
                                 .dynamic = true,
                                 .position = Eigen::Vector3d(1000.25 + 0.5 * x, 0.25, 0.25),
                                 .velocity = Eigen::Vector3d::Zero(),
                                 .size = Eigen::Vector3d::Constant(0.4)}};
    }
  }

  /// @param occupied places along x
  void save(std::int64_t frame, const std::vector<int>& occupied) {
    std::vector<PlyVertex> vertices;
    for (const int x : occupied) {
      vertices.push_back({{0.25F + 0.5F * static_cast<float>(x), 0.25F, 0.25F}, {}, 0.9F, 1});
    }
    std::filesystem::create_directories(folder_.path() / "maps");
    std::ofstream out(occupied_ply(folder_.path() / "maps", frame), std::ios::binary);
    write_ply(vertices, "origin_m 1000 0 0", out);
  }

  std::optional<RunGhosts> ghosts() { return ghosts_of_run(folder_.path(), run_, truth_); }
  std::string refusal() {
    return tests::message_of<ldm::InvalidInput>([this] { ghosts(); });
  }

  tests::TemporaryFolder folder_;
  std::map<std::int64_t, RunFrame> run_;
  TruthTable truth_;
};

TEST_F(GhostsOfARun, AreThoseOfItsSavedMaps) {
  EXPECT_FALSE(ghosts());
  save(0, {2});
  save(1, {2, 4});  // 2 is a ghost
  save(2, {4, 6});  // 4 is one, 2 is cleared after 0.2 s
  const RunGhosts found = ghosts().value();
  EXPECT_EQ(found.frames, 3);
  EXPECT_DOUBLE_EQ(found.voxels_per_frame, 2.0 / 3);
  EXPECT_DOUBLE_EQ(found.seconds_to_clear.value(), 0.2);  // 4 counts until the end, 0.1 s
  save(2, {2, 4, 6});
  EXPECT_FALSE(ghosts()->seconds_to_clear);
}

TEST_F(GhostsOfARun, FramesOutOfTheReferenceDoNotCount) {
  save(0, {2});
  save(1, {2, 4});
  save(2, {2, 6});
  truth_.erase(1);
  EXPECT_EQ(ghosts()->frames, 2);
  EXPECT_DOUBLE_EQ(ghosts()->voxels_per_frame, 0.5);
}

TEST_F(GhostsOfARun, WhatNoRunWroteIsRefused) {
  save(0, {2});
  const std::filesystem::path file = occupied_ply(folder_.path() / "maps", 0);
  const std::string map = folder_.read("maps/frame_000000.occupied.ply");
  folder_.write("maps/frame_000000.occupied.ply", map.substr(0, map.size() - 1));
  EXPECT_EQ(
      refusal(),
      file.string() + ": no map of a run: allowed: a file as `ldm run --save-frames` writes it");
  folder_.write("maps/frame_000000.occupied.ply", "plain" + map);
  EXPECT_NE(refusal().find("no map of a run"), std::string::npos);
  save(0, {2, 10});
  EXPECT_NE(refusal().find("a voxel outside of the map"), std::string::npos);
  folder_.write("summary.json", "{}");
  EXPECT_NE(refusal().find("summary.json: no summary of a run"), std::string::npos);
}

}  // namespace
}  // namespace experiments
