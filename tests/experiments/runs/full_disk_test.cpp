/// Every file that `ldm` writes, on a disk that is full: which file, in one line, and none left.
#include <gtest/gtest.h>

#include "tests/experiments/program.h"

namespace experiments {
namespace {

/// A shell's words: no file grows beyond so many times 512 bytes.
std::string full_after(int blocks) {
  return "trap '' XFSZ && ulimit -f " + std::to_string(blocks) + " && ";
}

class FullDisk : public Program {
 protected:
  void expect_failure(const std::string& arguments, int blocks, const std::string& file) {
    const Result result = ldm(arguments, full_after(blocks));
    EXPECT_EQ(result.code, 1) << result.error;
    EXPECT_EQ(result.error, "ldm: " + file + ": cannot be written: disk full?\n");
  }
};

TEST_F(FullDisk, TablesOfARun) {
  expect_failure("run ldm scenario1 --frames 20 -o o --set particles.count=500", 4,
                 "o/clusters.csv");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "o"));
}

TEST_F(FullDisk, SavedMaps) {
  expect_failure("run current_scan scenario1 --frames 20 -o o --save-frames 19 --save-as ply", 16,
                 "o/maps/frame_000019.free.ply");
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "o/maps")) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos);
  }
}

TEST_F(FullDisk, Pictures) {
  expect_failure("render current_scan scenario1 --frame 0 -o map.png", 16, "map.png");
  EXPECT_FALSE(exists("map.png"));
}

TEST_F(FullDisk, LogsAndRecords) {
  expect_failure("simulate scenario1 --frames 5 -o a.rawlog", 16, "a.rawlog");
  expect_failure("trial " + write_study() + " scenario1.current_scan.s001 -o r.json", 1, "r.json");
  EXPECT_FALSE(exists("a.rawlog"));
  EXPECT_FALSE(exists("r.json"));
}

TEST_F(FullDisk, FilmsWithWhatFfmpegSaysOfThem) {
  const std::filesystem::path ffmpeg =
      folder_.write("bin/ffmpeg",
                    "#!/bin/sh\nfor file; do :; done\ncat >/dev/null\n"
                    "echo \"$file: No space left on device\" >&2\nexit 1\n");
  std::filesystem::permissions(ffmpeg, std::filesystem::perms::owner_all);
  const Result result =
      ldm("render current_scan scenario1 --to 2 --video film.mp4", "PATH=./bin:$PATH");
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.error,
            "ldm: film.mp4: cannot be written: ffmpeg failed: the film: No space left on device\n");
  EXPECT_FALSE(exists("film.mp4"));
}

}  // namespace
}  // namespace experiments
