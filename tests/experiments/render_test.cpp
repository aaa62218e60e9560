#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/program.h"

namespace experiments {
namespace {

class RenderProgram : public Program {};

/// Width and height of a PNG file stand in its header, big-endian, from byte 16 on.
unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

TEST_F(RenderProgram, DrawsOnePictureOfTheStatedSize) {
  const Result result = ldm("render current_scan scenario1 --frame 2 -o x.png");
  ASSERT_EQ(result.code, 0) << result.error;
  const std::string png = folder_.read("x.png");
  ASSERT_GT(png.size(), 24U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(big_endian(png, 16), 1280U);
  EXPECT_EQ(big_endian(png, 20), 720U);
}

TEST_F(RenderProgram, RefusesWhatItCannotDraw) {
  expect_bad("render ldm scenario1 --frame 5000 -o x.png", "5000");
  expect_bad("render kalman scenario1 --frame 2 -o x.png", "unknown method kalman");
  EXPECT_FALSE(exists("x.png"));
}

}  // namespace
}  // namespace experiments
