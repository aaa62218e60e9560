#include "experiments/method/stage_clock.h"

#include <gtest/gtest.h>

#include <thread>

namespace experiments {
namespace {

TEST(TimeSummary, OrderStatisticsByHand) {
  const TimeSummary odd = summarize({3, 1, 2});
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(odd.mean, 2);
  EXPECT_EQ(odd.max, 3);
  EXPECT_EQ(summarize({4, 1, 2, 3}).median, 2.5);
  std::vector<double> hundred;
  for (int i = 100; i > 0; --i) hundred.push_back(i);
  EXPECT_EQ(summarize(hundred).p95, 95);
  EXPECT_EQ(summarize({}).max, 0);
}

TEST(StageClock, KeepsEveryStageOfEveryFrame) {
  StageClock clock;
  clock.start_frame();
  clock.begin("first");
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  clock.end_frame();
  clock.start_frame();
  clock.begin("second");
  clock.begin("first");
  clock.begin("second");  // goes on: one sample a frame
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  clock.end_frame();

  ASSERT_EQ(clock.stages().size(), 2u);
  EXPECT_EQ(clock.stages()[0].name, "first");
  EXPECT_EQ(clock.stages()[1].name, "second");
  ASSERT_EQ(clock.totals().size(), 2u);
  for (const StageClock::Stage& stage : clock.stages()) ASSERT_EQ(stage.ms.size(), 2u);
  EXPECT_GE(clock.stages()[0].ms[0], 2);
  EXPECT_EQ(clock.stages()[1].ms[0], 0);
  EXPECT_GE(clock.stages()[1].ms[1], 2);
  for (std::size_t frame = 0; frame < 2; ++frame) {
    EXPECT_LE(clock.stages()[0].ms[frame] + clock.stages()[1].ms[frame], clock.totals()[frame]);
  }
}

}  // namespace
}  // namespace experiments
