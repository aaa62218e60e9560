/// What of a recorded scan is left out, and counted.
#include "datasets/recording/filter/scan_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/text_file.h"

namespace datasets {
namespace {

/// One frame, once.
class OneScan : public FrameSource {
 public:
  explicit OneScan(ldm::Scan scan) : scan_(std::move(scan)) {}
  bool next(Frame& frame) override {
    frame.scan = scan_;
    return !std::exchange(given_, true);
  }
  std::optional<std::int64_t> size() const override { return 1; }

 private:
  ldm::Scan scan_;
  bool given_ = false;
};

struct Filtered {
  ldm::Scan scan;
  KeptPoints kept;
  InputCounts counts;
};

Filtered filtered(const ldm::Scan& scan, const InputParameters& parameters) {
  ScanFilter filter(std::make_unique<OneScan>(scan), parameters);
  Frame frame;
  EXPECT_TRUE(filter.next(frame));
  const Filtered result{frame.scan, frame.kept.value_or(KeptPoints{}), filter.counts()};
  EXPECT_FALSE(filter.next(frame));
  EXPECT_EQ(filter.size(), 1);
  return result;
}

TEST(ScanFilter, RangesAndNonFinitePoints) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  ldm::Scan scan;
  scan.points = {{0, 0, 0},    {0, 0.4F, 0}, {3, 0, 4},  {0, 0, 5.1F},
                 {kNan, 1, 1}, {1, kInf, 1}, {-2, 0, 0}, {1e30F, 0, 0}};
  InputParameters parameters;
  parameters.max_range = 5;
  const Filtered result = filtered(scan, parameters);
  EXPECT_EQ(result.scan.points, (std::vector<ldm::Point>{{3, 0, 4}, {-2, 0, 0}}));
  EXPECT_EQ(result.kept.recorded, 8u);
  EXPECT_EQ(result.kept.was, (std::vector<std::uint32_t>{2, 6}));
  EXPECT_EQ(result.counts.points_dropped,
            (InputCounts::ByReason{{"not finite", 2},
                                   {"nearer than input.min_range_m", 2},
                                   {"farther than input.max_range_m", 2}}));
}

TEST(ScanFilter, TheVehiclesBoxIsInItsFrame) {
  ldm::Scan scan;
  scan.T_world_uav.translation << 100, 0, 0;
  scan.T_world_sensor.translation << 101, 0, 2;  // 1 m before and 2 m above the vehicle's origin
  scan.T_world_sensor.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // looks to its left
  scan.points = {{0.6F, 0, -1}, {2, 0, -1}, {0.6F, 0, 1}};
  InputParameters parameters;
  parameters.body = {0, 2, -1, 1, 0, 1.5};
  const Filtered result = filtered(scan, parameters);
  EXPECT_EQ(result.scan.points, (std::vector<ldm::Point>{{2, 0, -1}, {0.6F, 0, 1}}));
  EXPECT_EQ(result.counts.points_dropped, (InputCounts::ByReason{{"on the vehicle", 1}}));
  parameters.body.z_max = 0;  // no box
  EXPECT_EQ(filtered(scan, parameters).scan.points.size(), 3u);
}

TEST(ScanFilter, GroundRaysStayAsRaysWithoutReturn) {
  ldm::Scan scan;
  for (int i = 0; i < 400; ++i) {
    scan.points.emplace_back(static_cast<float>(i % 20) - 9.5F, static_cast<float>(i / 20) - 9.5F,
                             -1.5F);
    scan.points.push_back(scan.points.back() + ldm::Point(0.1F, 0, 0));
    scan.points.push_back(scan.points.back() + ldm::Point(0, 0.1F, 0));
  }
  scan.points.emplace_back(5, 0, 0);
  InputParameters parameters;
  parameters.ground.removal = GroundRemoval::kPlane;
  const Filtered free = filtered(scan, parameters);
  EXPECT_EQ(free.scan.points, (std::vector<ldm::Point>{{5, 0, 0}}));
  EXPECT_EQ(free.kept.recorded, 1201u);
  EXPECT_EQ(free.kept.was, std::vector<std::uint32_t>{1200});
  ASSERT_EQ(free.scan.no_returns.size(), 1200u);
  EXPECT_TRUE(free.scan.no_returns[0].isApprox(scan.points[0].normalized()));
  EXPECT_EQ(free.counts.points_dropped, (InputCounts::ByReason{{"on the ground", 1200}}));
  parameters.ground.rays = GroundRays::kDrop;
  EXPECT_TRUE(filtered(scan, parameters).scan.no_returns.empty());
}

TEST(ScanFilter, AFrameWithoutGroundIsCountedAndStaysWhole) {
  ldm::Scan scan;
  scan.points = {{5, 0, 0}, {5, 1, 0}};
  InputParameters parameters;
  parameters.ground.removal = GroundRemoval::kGrid;
  const Filtered result = filtered(scan, parameters);
  EXPECT_EQ(result.scan.points.size(), 2u);
  EXPECT_EQ(result.counts.other,
            (InputCounts::ByReason{{"frames in which no ground was found", 1},
                                   {"scans whose pattern of rays is not certain", 1}}));
}

/// Eight rings of 360 firings at 10 m, without those that meet nothing: 0 to 29 degrees.
ldm::Scan scan_with_a_gap() {
  ldm::Scan scan;
  for (int i = 0; i < 8 * 360; ++i) {
    constexpr double kDegree = std::numbers::pi / 180;
    const double elevation = kDegree * (i / 360 - 3), azimuth = kDegree * (i % 360);
    if (i % 360 < 30) continue;
    scan.points.push_back(
        (10 * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation)))
            .cast<float>());
  }
  return scan;
}

TEST(ScanFilter, RaysWithoutAReturnAreFoundUnlessTheRecordingHasThem) {
  ldm::Scan scan = scan_with_a_gap();
  InputParameters parameters;
  const Filtered result = filtered(scan, parameters);
  EXPECT_EQ(result.scan.no_returns.size(), 8u * 30);
  EXPECT_EQ(result.scan.points.size(), 8u * 330);
  EXPECT_TRUE(result.counts.other.empty());
  parameters.no_returns = NoReturns::kLog;
  EXPECT_TRUE(filtered(scan, parameters).scan.no_returns.empty());
  parameters.no_returns = NoReturns::kPattern;
  scan.no_returns = {{0, 0, 1}};
  EXPECT_EQ(filtered(scan, parameters).scan.no_returns, scan.no_returns);
}

/// A scan in which points do not lie on rings: nothing, or gaps if told so, but not where the
/// source knows better.
TEST(ScanFilter, GapsAreRaysWithoutAReturnIfToldSo) {
  ldm::Scan scan = scan_with_a_gap();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    scan.points[i].z() += 0.08F * std::sin(static_cast<float>(i));
  }
  InputParameters parameters;
  EXPECT_TRUE(filtered(scan, parameters).scan.no_returns.empty());
  parameters.no_returns = NoReturns::kGaps;
  const Filtered result = filtered(scan, parameters);
  EXPECT_GT(result.scan.no_returns.size(), 100u);
  for (const ldm::Point& ray : result.scan.no_returns) {
    EXPECT_NEAR(std::atan2(ray.y(), ray.x()) * 180 / std::numbers::pi, 14.5, 15);
  }
  EXPECT_EQ(result.counts.other,
            (InputCounts::ByReason{{"scans whose pattern of rays is not certain", 1}}));
  for (const RaysToFind rays : {RaysToFind::kOfGaps, RaysToFind::kNone}) {
    ScanFilter filter(std::make_unique<OneScan>(scan), parameters, rays);
    Frame frame;
    EXPECT_TRUE(filter.next(frame));
    EXPECT_EQ(frame.scan.no_returns.size(),
              rays == RaysToFind::kNone ? 0 : result.scan.no_returns.size());
    EXPECT_TRUE(filter.counts().other.empty());
  }
}

// What is left out as too near, or on the vehicle, returned all the same.
TEST(ScanFilter, APointThatIsLeftOutIsNoRayWithoutAReturn) {
  InputParameters parameters;
  parameters.min_range = 20;
  const Filtered result = filtered(scan_with_a_gap(), parameters);
  EXPECT_TRUE(result.scan.points.empty());
  EXPECT_EQ(result.scan.no_returns.size(), 8u * 30);
}

TEST(ScanFilter, ARayToAPointOutOfRangeIsFree) {
  ldm::Scan scan;
  scan.points = {{3, 0, 4}, {0, 6, 0}, {1e30F, 0, 0}, {NAN, 0, 0}};
  InputParameters parameters;
  parameters.max_range = 5.5;
  EXPECT_EQ(filtered(scan, parameters).scan.no_returns,
            (std::vector<ldm::Point>{{0, 1, 0}, {1, 0, 0}}));
  parameters.no_returns = NoReturns::kLog;
  EXPECT_TRUE(filtered(scan, parameters).scan.no_returns.empty());
}

TEST(ScanFilter, BoundsThatCross) {
  InputParameters parameters;
  parameters.min_range = 6;
  parameters.max_range = 5;
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { filtered({}, parameters); }),
            "input.min_range_m = 6: allowed: at most input.max_range_m = 5");
  parameters.max_range = 7;
  parameters.body.y_min = 1;
  EXPECT_NE(
      tests::message_of<ldm::InvalidInput>([&] { filtered({}, parameters); }).find("body.y_min_m"),
      std::string::npos);
}

}  // namespace
}  // namespace datasets
