#include "experiments/runs/played_frames.h"

#include <gtest/gtest.h>

#include <thread>

namespace experiments {
namespace {

/// Frames at 0, 0.1, 0.2, ... s.
class FiveFrames : public datasets::FrameSource {
 public:
  bool next(datasets::Frame& frame) override {
    frame.index = next_;
    frame.scan.time = 7 + 0.1 * static_cast<double>(next_);
    return next_++ < 5;
  }
  std::optional<std::int64_t> size() const override { return 5; }

 private:
  std::int64_t next_ = 0;
};

double seconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

bool never() {
  return false;
}

TEST(PlayedFrames, WithoutARateComeAtOnce) {
  FiveFrames source;
  PlayedFrames frames(source, {}, never);
  const auto began = std::chrono::steady_clock::now();
  datasets::Frame frame;
  std::int64_t count = 0;
  while (frames.next(frame)) ++count;
  EXPECT_EQ(count, 5);
  EXPECT_LT(seconds_since(began), 0.2);
  EXPECT_EQ(frames.size(), 5);
}

TEST(PlayedFrames, ComeWhenTheyAreDue) {
  FiveFrames source;
  PlayedFrames frames(source, 4, never);
  const auto began = std::chrono::steady_clock::now();
  datasets::Frame frame;
  while (frames.next(frame)) EXPECT_GE(seconds_since(began), (frame.scan.time - 7) / 4 - 1e-6);
}

TEST(PlayedFrames, CountWhatTheMethodWasTooSlowFor) {
  FiveFrames source;
  PlayedFrames frames(source, 10, never);  // one each 10 ms
  datasets::Frame frame;
  frames.next(frame);
  frames.next(frame);
  EXPECT_LT(frames.lateness().frames, 2);
  const std::int64_t before = frames.lateness().frames;
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  while (frames.next(frame)) {
  }
  EXPECT_EQ(frames.lateness().frames, before + 3);
  EXPECT_GE(frames.lateness().worst, 0.039);
}

TEST(PlayedFrames, EndWhenAsked) {
  FiveFrames source;
  bool ended = false;
  PlayedFrames frames(source, {}, [&] { return ended; });
  datasets::Frame frame;
  EXPECT_TRUE(frames.next(frame));
  ended = true;
  EXPECT_FALSE(frames.next(frame));
}

TEST(PlayedFrames, EndInMidWait) {
  FiveFrames source;
  const auto began = std::chrono::steady_clock::now();
  PlayedFrames frames(source, 0.001, [&] { return seconds_since(began) > 0.1; });
  datasets::Frame frame;
  EXPECT_TRUE(frames.next(frame));
  EXPECT_FALSE(frames.next(frame));  // due in 100 s
  EXPECT_LT(seconds_since(began), 5);
}

}  // namespace
}  // namespace experiments
