/// `ldm render`, from outside.
#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/program.h"

namespace experiments {
namespace {

constexpr char kFast[] = " --set particles.count=500 --set execution.threads=1";

/// Columns and rows, as the first chunk of a PNG says.
std::pair<int, int> size_of_png(const std::string& bytes) {
  if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {0, 0};
  const auto number = [&](std::size_t begin) {
    int value = 0;
    for (std::size_t i = begin; i < begin + 4; ++i) {
      value = value * 256 + static_cast<unsigned char>(bytes[i]);
    }
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(Program, RenderWritesOnePictureWithoutADisplay) {
  const Result result = ldm("render ldm scenario3 --frame 3 -o map.png" + std::string(kFast),
                            "DISPLAY= WAYLAND_DISPLAY=");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.out + result.error, "");
  EXPECT_EQ(size_of_png(folder_.read("map.png")), std::pair(1280, 720));
  const std::filesystem::directory_iterator files(folder_.path()), end;
  EXPECT_EQ(std::distance(files, end), 3);  // and out, error: nothing else was left
}

TEST_F(Program, ALogIsDrawnLikeItsScenario) {
  ASSERT_EQ(ldm("simulate scenario1 --seed 7 --frames 3 -o scenario1.rawlog").code, 0);
  ASSERT_EQ(ldm("render current_scan scenario1.rawlog --frame 2 -o log.png").code, 0);
  ASSERT_EQ(ldm("render current_scan scenario1 --frame 2 --seed 7 -o live.png").code, 0);
  ASSERT_EQ(ldm("render current_scan scenario1 --frame 2 --seed 8 -o other.png").code, 0);
  EXPECT_EQ(size_of_png(folder_.read("log.png")), size_of_png(folder_.read("live.png")));
  EXPECT_NE(folder_.read("live.png"), folder_.read("other.png"));
  expect_bad("render current_scan scenario1.rawlog --frame 3 -o log.png",
             "--frame 3: allowed: 0 to 2, the frames of scenario1.rawlog");
}

TEST_F(Program, RefusesBadRenders) {
  expect_bad("render ldm scenario1 -o a.png", "--frame is required");
  expect_bad("render ldm scenario1 --frame -1 -o a.png", "--frame");
  expect_bad("render ldm scenario1 --frame 1200 -o a.png",
             "--frame 1200: allowed: 0 to 1199, the frames of scenario1");
  expect_bad("render kalman scenario1 --frame 0 -o a.png", "unknown method kalman: allowed: ldm");
  expect_bad("render ldm moon --frame 0 -o a.png", "moon: no such recording or scenario");
  expect_bad("render ldm scenario1 --frame 0 -o a.jpg", "--output a.jpg: allowed: FILE.png");
  expect_bad("render ldm scenario1 --frame 0 -o none/a.png", "none/a.png: cannot be written");
  expect_bad("render octomap scenario1 --frame 0 -o a.png --set particles.count=15",
             "parameters that octomap uses");
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(Program, ARunIsDrawnAsItWas) {
  ASSERT_EQ(ldm("run ldm scenario3 --seed 4 --frames 5 -o o" + std::string(kFast)).code, 0);
  ASSERT_EQ(ldm("render o --frame 4 -o run.png").code, 0);
  ASSERT_EQ(ldm("render ldm scenario3 --seed 4 --frame 4 -o live.png" + std::string(kFast)).code,
            0);
  EXPECT_EQ(folder_.read("run.png"), folder_.read("live.png"));
}

TEST_F(Program, ARunOfALogIsDrawnFromAnyFolder) {
  ASSERT_EQ(ldm("simulate scenario3 --frames 3 -o a.rawlog").code, 0);
  ASSERT_EQ(ldm("run ldm a.rawlog -o o" + std::string(kFast)).code, 0);
  ASSERT_EQ(ldm("render o --frame 2 -o a.png").code, 0);
  const Result result = run("cd", "o && " LDM_PROGRAM " render . --frame 2 -o b.png");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(folder_.read("a.png"), folder_.read("o/b.png"));
}

TEST_F(Program, RefusesBadRunsToDraw) {
  expect_bad("render none --frame 0 -o a.png", "none/summary.json: cannot be read: allowed: ");
  folder_.write("o/summary.json", "{\"schema\": 1}");
  expect_bad("render o --frame 0 -o a.png", "o/summary.json: no summary of this version");
  expect_bad("render o --frame 0 -o a.png --seed 3", "RUN o: is repeated as it was");
  ASSERT_EQ(ldm("run current_scan scenario3 --frames 1 -o seeded").code, 0);
  std::string summary = folder_.read("seeded/summary.json");
  const std::string seed = "\"seed\":\"1\"";
  ASSERT_NE(summary.find(seed), std::string::npos) << summary;
  folder_.write("seeded/summary.json",
                summary.replace(summary.find(seed), seed.size(), "\"seed\":\"-1\""));
  expect_bad("render seeded --frame 0 -o a.png",
             "seeded/summary.json: source.seed = -1: allowed: a whole number from 0 on");
}

/// A program of this name that keeps its arguments and what it is fed.
void write_ffmpeg(const tests::TemporaryFolder& folder, const std::string& end) {
  const std::filesystem::path file =
      folder.write("bin/ffmpeg", "#!/bin/sh\necho \"$@\" > arguments\n" + end);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

TEST_F(Program, AFilmIsFedToFfmpegPictureByPicture) {
  write_ffmpeg(folder_, "cat > pixels\necho film > \"$(eval echo \\${$#})\"\n");
  const Result result =
      ldm("render current_scan scenario1 --video a.mp4 --from 1 --to 3", "PATH=$PWD/bin:$PATH");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(folder_.read("a.mp4"), "film\n");
  const std::string arguments = folder_.read("arguments");
  EXPECT_NE(arguments.find("-s 1280x720 -r 10 -i -"), std::string::npos) << arguments;
  const std::string pixels = folder_.read("pixels");
  ASSERT_EQ(pixels.size(), 3u * 1280 * 720 * 3);
  EXPECT_EQ(pixels.substr(0, 300), std::string(300, '\xff'));  // a light background
  EXPECT_NE(pixels.substr(0, pixels.size() / 3), pixels.substr(pixels.size() / 3 * 2));
}

TEST_F(Program, WhatFfmpegDoesWrongLeavesNothing) {
  write_ffmpeg(folder_, "cat > /dev/null\nexit 3\n");
  Result result = ldm("render current_scan scenario1 --video a.mp4 --to 2", "PATH=$PWD/bin:$PATH");
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.error, "ldm: a.mp4: cannot be written: ffmpeg failed\n");
  write_ffmpeg(folder_, "exit 0\n");
  result = ldm("render current_scan scenario1 --video a.mp4 --to 2", "PATH=$PWD/bin:$PATH");
  EXPECT_EQ(result.code, 1);
  EXPECT_FALSE(exists("a.mp4"));
}

TEST_F(Program, AFilmWithoutFfmpegIsRefused) {
  const Result result = ldm("render current_scan scenario1 --video a.mp4 --to 2", "PATH=/none");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.error,
            "ldm: --video a.mp4: there is no ffmpeg: allowed: with Debian's package "
            "ffmpeg installed\n");
  EXPECT_FALSE(exists("a.mp4"));
}

TEST_F(Program, RefusesBadFilms) {
  expect_bad("render ldm scenario1", "--output is required: allowed: -o FILE.png with --frame, or");
  expect_bad("render ldm scenario1 --video a.avi", "--video a.avi: allowed: FILE.mp4");
  expect_bad("render ldm scenario1 --video a.mp4 --from 5 --to 4", "--to 4: allowed: not before");
  expect_bad("render ldm scenario1 --video a.mp4 --from 1200", "--from 1200: allowed: 0 to 1199");
  expect_bad("render ldm scenario1 --video a.mp4 --to 1200", "--to 1200: allowed: 0 to 1199");
  expect_bad("render ldm scenario1 --video a.mp4 --frame 3", "--output is required with --frame");
  expect_bad("render ldm scenario1 --video a.mp4 --frame 3 -o a.png", "allowed: one of them");
}

TEST_F(Program, ViewWithoutADisplayIsRefused) {
  const Result result = ldm("view current_scan scenario1", "DISPLAY= WAYLAND_DISPLAY=");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(lines(result.error), 1u) << result.error;
  EXPECT_EQ(result.error.rfind("ldm: view: ", 0), 0u) << result.error;
}

TEST_F(Program, RenderWithoutEglFailsInOneLineAndLeavesNothing) {
  const Result result = ldm("render current_scan scenario1 --frame 0 -o a.png",
                            "__EGL_VENDOR_LIBRARY_FILENAMES=/none");
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(lines(result.error), 1u) << result.error;
  EXPECT_NE(result.error.find("ldm: cannot draw: EGL offers no device"), std::string::npos)
      << result.error;
  const std::filesystem::directory_iterator files(folder_.path()), end;
  EXPECT_EQ(std::distance(files, end), 2);  // out, error
}

}  // namespace
}  // namespace experiments
