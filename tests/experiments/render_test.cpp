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
  expect_bad("render ldm moon --frame 0 -o a.png", "unknown scenario moon");
  expect_bad("render ldm scenario1 --frame 0 -o a.jpg", "--output a.jpg: allowed: FILE.png");
  expect_bad("render ldm scenario1 --frame 0 -o none/a.png", "none/a.png: cannot be written");
  expect_bad("render octomap scenario1 --frame 0 -o a.png --set particles.count=15",
             "parameters that octomap uses");
  EXPECT_FALSE(exists("a.png"));
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
