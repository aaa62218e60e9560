/// Recorded logs: what was written reads back bit for bit.
#include "datasets/rawlog/rawlog.h"

#include <gtest/gtest.h>

#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "datasets/scenario/simulation.h"
#include "tests/datasets/rawlog/rawlog_recording.h"
#include "tests/full_disk.h"
#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

/// A point's or number's bits: EXPECT_EQ would take -0 for 0.
template <class T>
void expect_same_bits(const T& a, const T& b) {
  EXPECT_EQ(std::memcmp(&a, &b, sizeof(T)), 0);
}

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same(const ObjectState& a, const ObjectState& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.dynamic, b.dynamic);
  expect_same_bits(a.position, b.position);
  expect_same_bits(a.velocity, b.velocity);
  expect_same_bits(a.acceleration, b.acceleration);
  expect_same_bits(a.size, b.size);
  ASSERT_EQ(a.solids.size(), b.solids.size());
  for (std::size_t i = 0; i < a.solids.size(); ++i) {
    EXPECT_EQ(a.solids[i].shape, b.solids[i].shape);
    expect_same_bits(a.solids[i].T_world_solid, b.solids[i].T_world_solid);
    expect_same_bits(a.solids[i].size, b.solids[i].size);
  }
}

void expect_same(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.index, b.index);
  expect_same_bits(a.scan.time, b.scan.time);
  expect_same_bits(a.scan.T_world_uav, b.scan.T_world_uav);
  expect_same_bits(a.scan.T_world_sensor, b.scan.T_world_sensor);
  expect_same_bits(a.scan.points, b.scan.points);
  expect_same_bits(a.scan.no_returns, b.scan.no_returns);
  ASSERT_TRUE(a.truth && b.truth);
  expect_same_bits(a.truth->noise_free_hits, b.truth->noise_free_hits);
  ASSERT_EQ(a.truth->objects.size(), b.truth->objects.size());
  for (std::size_t i = 0; i < a.truth->objects.size(); ++i) {
    expect_same(a.truth->objects[i], b.truth->objects[i]);
  }
}

TEST_F(Rawlog, ReadsBackBitForBit) {
  RawlogReader reader(rawlog());
  EXPECT_EQ(reader.size(), kFrames);
  expect_same_bits(reader.lidar().elevations, recording_.lidar.elevations);
  EXPECT_EQ(reader.lidar().rate, recording_.lidar.rate);
  expect_same_bits(reader.T_uav_sensor(), recording_.T_uav_sensor);
  Frame frame;
  for (const Frame& written : recording_.frames) {
    ASSERT_TRUE(reader.next(frame));
    expect_same(frame, written);
  }
  EXPECT_FALSE(reader.next(frame));
  EXPECT_FALSE(reader.next(frame));
}

TEST_F(Rawlog, ASimulatedScenarioReadsBackBitForBit) {
  const Scenario scenario =
      read_scenario(tests::source_folder() / "datasets/scenarios/scenario3.toml");
  constexpr std::int64_t kSimulated = 20;
  Simulation simulation(scenario, 1, kSimulated), again(scenario, 1, kSimulated);
  Frame frame, expected;
  RawlogWriter writer(rawlog(), simulation.lidar(), simulation.T_uav_sensor());
  while (simulation.next(frame)) {
    writer.write(frame.scan.time, simulation.uav_pose(), simulation.range_image(), *frame.truth);
  }
  writer.close();

  RawlogReader reader(rawlog());
  for (std::int64_t k = 0; k < kSimulated; ++k) {
    ASSERT_TRUE(again.next(expected) && reader.next(frame));
    expect_same(frame, expected);
  }
  EXPECT_FALSE(reader.next(frame));
}

TEST_F(Rawlog, RecordingHasReturnsAndHits) {
  EXPECT_FALSE(recording_.frames[0].scan.points.empty());
  EXPECT_FALSE(recording_.frames[0].truth->noise_free_hits.empty());
  EXPECT_TRUE(recording_.frames[2].truth->noise_free_hits.empty());
}

TEST_F(Rawlog, WritesTheSameBytesAgain) {
  const std::string before = content("flight.rawlog");
  write();
  EXPECT_EQ(content("flight.rawlog"), before);
}

TEST_F(Rawlog, NothingStandsUnderItsNameUntilClosed) {
  const auto files = [this] { return std::distance(fs::directory_iterator(folder_), {}); };
  EXPECT_EQ(files(), 5);
  {
    RawlogWriter writer(file("other.rawlog"), recording_.lidar, recording_.T_uav_sensor);
    writer.write(0, recording_.poses[0], recording_.images[0], *recording_.frames[0].truth);
    EXPECT_FALSE(fs::exists(file("other.rawlog")));
  }
  EXPECT_EQ(files(), 5);
}

TEST_F(Rawlog, AFullDiskIsReportedAndLeavesTheOldLog) {
  for (const rlim_t limit : {100, 1000, 3000}) {
    std::string message;
    {
      const tests::FullDisk disk(limit);
      message = tests::message_of<std::runtime_error>([this] { write(); });
    }
    EXPECT_EQ(message.find(file("flight.").string()), 0U) << message;
    EXPECT_EQ(message.find(".part"), std::string::npos) << message;
    EXPECT_NE(message.find(": cannot be written: disk full?"), std::string::npos) << message;
    EXPECT_EQ(failure(), "none");
  }
}

TEST_F(Rawlog, EmptyLogIsValid) {
  recording_.frames.clear();
  write();
  RawlogReader reader(rawlog());
  Frame frame;
  EXPECT_EQ(reader.size(), 0);
  EXPECT_FALSE(reader.next(frame));
}

}  // namespace
}  // namespace datasets
