#include "ldm/occupancy_update.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "ldm/measurement_flags.h"
#include "tests/ldm/random_inputs.h"

namespace ldm {
namespace {

constexpr float kHit = 0.847298F;     // ln(0.7 / 0.3)
constexpr float kCross = -0.405465F;  // ln(0.4 / 0.6)

/// A static object, or none, in each slot.
struct Kept {
  explicit Kept(std::size_t slots) : owner(slots) {}
  StaticVoxels voxels() const { return {&owner, is_static}; }

  SparseNumbers owner;
  std::vector<std::uint8_t> is_static = {1, 0};
};

class OccupancyUpdateTest : public testing::Test {
 protected:
  OccupancyUpdateTest() : log_odds_(map_.voxels) {}

  OccupancyUpdate update() const { return {map_, sensor_, survival_}; }

  /// Log-odds of a voxel that had `l` and gets `flag`; `kept`: a static object stands there.
  float after(float l, std::uint8_t flag, bool kept = false) {
    std::fill(log_odds_.cells().begin(), log_odds_.cells().end(), l);
    const std::vector<std::uint8_t> flags(log_odds_.cells().size(), flag);
    Kept keep(flags.size());
    for (std::size_t slot = 0; slot < flags.size(); ++slot)
      keep.owner.writer().set(slot, kept ? 1 : 2);
    update().apply(flags, keep.voxels(), log_odds_);
    for (const float cell : log_odds_.cells()) EXPECT_EQ(cell, log_odds_.cells()[0]);
    return log_odds_.cells()[0];
  }

  MapParameters map_ = map_of({5, 6, 7});
  SensorModelParameters sensor_;
  SurvivalParameters survival_;
  RingBuffer<float> log_odds_;
};

// Eq. (9)
TEST_F(OccupancyUpdateTest, LogOddsOfAMeasurementByItsFlag) {
  const MeasurementLogOdds z(sensor_);
  EXPECT_NEAR(z.occupied, kHit, 1e-6);
  EXPECT_NEAR(z.free, kCross, 1e-6);
  EXPECT_NEAR(after(0, flag::kOccupied), kHit, 1e-6);
  EXPECT_NEAR(after(0, flag::kFree), kCross, 1e-6);
}

// Eq. (8)
TEST_F(OccupancyUpdateTest, MeasurementsAddUpWithinTheClamps) {
  EXPECT_NEAR(update().measured(1.0F, kHit), 1.847298, 1e-6);
  EXPECT_NEAR(after(1.0F, flag::kOccupied), 1.847298, 1e-6);
  EXPECT_NEAR(after(1.0F, flag::kFree), 0.594535, 1e-6);
  EXPECT_EQ(after(3.0F, flag::kOccupied), 3.5F);
  EXPECT_EQ(after(3.5F, flag::kOccupied), 3.5F);
  EXPECT_EQ(after(-1.8F, flag::kFree), -2.0F);
  EXPECT_NEAR(after(-2.0F, flag::kOccupied), -1.152702, 1e-6);
}

// Eq. (10)
TEST_F(OccupancyUpdateTest, SurvivalScalesLogOddsUntilNothingIsLeft) {
  EXPECT_FLOAT_EQ(OccupancyUpdate::survived(2.0F, 0.9F), 1.8F);
  EXPECT_FLOAT_EQ(OccupancyUpdate::survived(-2.0F, 0.25F), -0.5F);
  EXPECT_EQ(OccupancyUpdate::survived(1.5F, 1.0F), 1.5F);
  EXPECT_EQ(OccupancyUpdate::survived(3.5F, 0.0F), 0.0F);
  for (const float start : {3.5F, -2.0F}) {
    float l = start;
    int frames = 0;
    for (; l != 0; ++frames) {
      const float next = OccupancyUpdate::survived(l, 0.9F);
      ASSERT_LT(std::abs(next), std::abs(l));
      ASSERT_TRUE(next == 0 || std::isnormal(next));
      l = next;
    }
    EXPECT_GT(frames, 100);
    EXPECT_LT(frames, 200);
  }
}

TEST_F(OccupancyUpdateTest, FirstCaseStaticObjectsStay) {
  for (const std::uint8_t f : {flag::kNone, std::uint8_t{1}, flag::kShadow}) {
    EXPECT_EQ(after(2.5F, f, true), 2.5F);
  }
  EXPECT_NEAR(after(1.0F, flag::kFree, true), 0.594535, 1e-6);  // but they can be measured
  EXPECT_NEAR(after(1.0F, flag::kOccupied, true), 1.847298, 1e-6);
}

TEST_F(OccupancyUpdateTest, SecondCaseOutOfTheSensorsView) {
  EXPECT_FLOAT_EQ(after(2.0F, flag::kNone), 1.8F);
  EXPECT_FLOAT_EQ(after(-1.0F, flag::kNone), -0.9F);
  survival_.outside_view = 0.5;
  EXPECT_FLOAT_EQ(after(2.0F, flag::kNone), 1.0F);
}

/// At 0.15 m a voxel a flag falls by one each 0.075 m behind the obstacle.
TEST_F(OccupancyUpdateTest, ThirdCaseBehindAnObstacle) {
  const auto shadow = [](int half_voxels) {
    return static_cast<std::uint8_t>(flag::kShadow - half_voxels);
  };
  EXPECT_FLOAT_EQ(after(1.0F, shadow(0)), 0.98F);
  EXPECT_FLOAT_EQ(after(1.0F, shadow(2)), 0.98F);         // 0.15 m
  EXPECT_FLOAT_EQ(after(1.0F, shadow(4)), 0.98F);         // 0.3 m: as far as it stays high
  EXPECT_FLOAT_EQ(after(1.0F, shadow(5)), 0.98F * 0.8F);  // 0.375 m: 0.98 * 0.3 / 0.375
  EXPECT_FLOAT_EQ(after(1.0F, shadow(8)), 0.49F);         // 0.6 m
  EXPECT_NEAR(after(-1.0F, 1), -0.98 * 0.3 / 18.9, 1e-6);
  survival_.shadow = 0.5;
  survival_.shadow_range = 0.6;
  EXPECT_FLOAT_EQ(after(1.0F, shadow(8)), 0.5F);
  EXPECT_FLOAT_EQ(after(1.0F, shadow(16)), 0.25F);
}

TEST_F(OccupancyUpdateTest, WithoutSurvivalUnseenVoxelsKeepTheirLogOdds) {
  survival_.enabled = false;
  for (const std::uint8_t f : {flag::kNone, std::uint8_t{1}, std::uint8_t{200}, flag::kShadow}) {
    EXPECT_EQ(after(1.25F, f), 1.25F);
    EXPECT_EQ(after(-0.5F, f), -0.5F);
  }
  EXPECT_NEAR(after(1.0F, flag::kOccupied), 1.847298, 1e-6);
}

TEST_F(OccupancyUpdateTest, WithoutStaticObjectsKeptMayBeEmpty) {
  std::fill(log_odds_.cells().begin(), log_odds_.cells().end(), 2.0F);
  const std::vector<std::uint8_t> flags(log_odds_.cells().size(), flag::kNone);
  update().apply(flags, {}, log_odds_);
  for (const float l : log_odds_.cells()) EXPECT_FLOAT_EQ(l, 1.8F);
}

/// Flags in runs of up to `most` alike.
std::vector<std::uint8_t> runs_of_flags(std::size_t n, int most, Random& random) {
  std::vector<std::uint8_t> flags;
  while (flags.size() < n) {
    const auto some = static_cast<std::size_t>(uniform_int(1, most, random));
    flags.insert(flags.end(), std::min(some, n - flags.size()),
                 static_cast<std::uint8_t>(uniform_int(0, 255, random)));
  }
  return flags;
}

// What a brick is known to hold decides whether it is looked at: the bits are those of a map of
// which nothing is known.
TEST(OccupancyUpdateBricksTest, WhatIsPassedOverWouldHaveStayed) {
  Random random(7);
  const Eigen::Vector3i n(33, 20, 9);
  RingBuffer<float> known(n);
  RingBuffer<float> unknown(n);
  const OccupancyUpdate update(map_of(n), {}, {});
  std::size_t uniform_bricks = 0;
  for (int frame = 0; frame < 60; ++frame) {
    const VoxelIndex centre(frame / 4, -frame / 7, 0);
    known.recenter(centre);
    unknown.recenter(centre);
    const auto flags = runs_of_flags(known.index().count(), frame % 3 == 0 ? 400 : 2000, random);
    Kept kept(flags.size());
    for (int i = 0; i < 200; ++i) {
      kept.owner.writer().set(static_cast<std::size_t>(uniform_int(0, 33 * 20 * 9 - 1, random)),
                              static_cast<std::uint32_t>(uniform_int(1, 2, random)));
    }
    for (std::size_t b = 0; b < bricks_of(flags.size()); ++b) {
      uniform_bricks += std::as_const(known).range(b).is_one() ? 1 : 0;
    }
    unknown.cells();  // may be anything from here on
    update.apply(flags, kept.voxels(), known);
    update.apply(flags, kept.voxels(), unknown);
    ASSERT_TRUE(std::ranges::equal(std::as_const(known).cells(), std::as_const(unknown).cells()));
  }
  EXPECT_GT(uniform_bricks, 100u);
}

/// Flags come in window order, `kept` and log-odds in slots: here they are told apart. Stretches of
/// one flag, of several, and with static objects go ways of their own, all to the same bits.
class OccupancyUpdateOrderTest : public testing::TestWithParam<std::tuple<bool, int, int>> {};

TEST_P(OccupancyUpdateOrderTest, FlagsMeetTheirVoxelWhereverTheWindowIs) {
  const auto [survives, most_alike, one_kept_in] = GetParam();
  Random random(1);
  const MeasurementLogOdds z{SensorModelParameters{}};
  std::vector<Eigen::Vector3i> sizes = map_sizes();
  sizes.push_back({RingIndex::kMostVoxels, 5, 5});
  for (const Eigen::Vector3i& n : sizes) {
    RingBuffer<float> log_odds(n);
    log_odds.recenter(random_vector(-600, 600, random));
    const auto flags = runs_of_flags(log_odds.cells().size(), most_alike, random);
    Kept kept(flags.size());
    for (std::size_t slot = 0; one_kept_in > 0 && slot < flags.size(); ++slot) {
      if (uniform_int(1, one_kept_in, random) == 1) kept.owner.writer().set(slot, 1);
    }
    for (auto& l : log_odds.cells()) {
      l = static_cast<float>(uniform(-2, 3.5, random));
      if (uniform_int(1, 8, random) == 1) l *= 1e-7F;  // survival leaves nothing of it
    }
    const RingBuffer<float> before = log_odds;
    SurvivalParameters survival;
    survival.enabled = survives;
    const OccupancyUpdate update(map_of(n), {}, survival, uniform_int(1, 4, random));
    update.apply(flags, one_kept_in > 0 ? kept.voxels() : StaticVoxels{}, log_odds);

    for (std::size_t slot = 0; slot < log_odds.cells().size(); ++slot) {
      const LogOddsRange& range = std::as_const(log_odds).range(slot / kBrick);
      ASSERT_LE(range.low, std::as_const(log_odds).cells()[slot]);
      ASSERT_GE(range.high, std::as_const(log_odds).cells()[slot]);
    }
    const VoxelBox& window = log_odds.index().window();
    for_each_voxel(window, [&](const VoxelIndex& v, std::size_t i) {
      const std::uint8_t f = flags[i];
      const float l_z = f == flag::kOccupied ? z.occupied : f == flag::kFree ? z.free : 0;
      const bool stays = kept.voxels().at(log_odds.index().slot(v));
      const bool untouched = l_z == 0 && update.survival(f) == 1;
      const float p_s = stays ? 1 : update.survival(f);
      const float expected =
          untouched ? before.at(v)
                    : update.measured(OccupancyUpdate::survived(before.at(v), p_s), l_z);
      const float after = log_odds.cells()[log_odds.index().slot(v)];
      ASSERT_EQ(after, expected) << v.transpose() << " of " << n.transpose();
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Stretches, OccupancyUpdateOrderTest,
                         testing::Combine(testing::Bool(), testing::Values(1, 60),
                                          testing::Values(0, 2, 60)));

}  // namespace
}  // namespace ldm
