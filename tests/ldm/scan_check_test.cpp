#include "ldm/scan_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace ldm {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Scan good_scan() {
  Scan scan;
  scan.time = 12.5;
  scan.T_world_uav.translation = {1, -2, 3};
  scan.T_world_sensor.translation = {1, -2, 3.2};
  for (int i = 0; i < 20; ++i) {
    scan.points.emplace_back(1.0F, 0.1F * static_cast<float>(i), -2.0F);
    scan.no_returns.emplace_back(0.0F, 0.6F, 0.8F);
  }
  return scan;
}

/// What check_scan says of the good scan after `spoil`; empty if it takes it.
std::string refusal(const std::function<void(Scan&)>& spoil,
                    std::optional<double> previous_time = std::nullopt) {
  Scan scan = good_scan();
  spoil(scan);
  try {
    check_scan(scan, previous_time);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(ScanCheckTest, TakesGoodScans) {
  const auto as_it_is = [](Scan&) {};
  EXPECT_EQ(refusal(as_it_is), "");
  EXPECT_EQ(refusal(as_it_is, 12.4), "");
  EXPECT_EQ(refusal(as_it_is, 12.5), "");  // the same instant is not backwards
  EXPECT_EQ(refusal([](Scan& s) { s = Scan{}; }), "");
  EXPECT_EQ(refusal([](Scan& s) { s.time = -1e9; }), "");
  EXPECT_EQ(refusal([](Scan& s) { s.points[3].setConstant(-1e7F); }), "");
  EXPECT_EQ(refusal([](Scan& s) { s.T_world_uav.translation = {1e7, -1e7, 0}; }), "");
}

TEST(ScanCheckTest, RefusesTimes) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    const std::string said = refusal([&](Scan& s) { s.time = bad; });
    EXPECT_EQ(said, "scan.time = " + std::to_string(bad) + " s: allowed: a finite number");
  }
  EXPECT_EQ(refusal([](Scan&) {}, 12.75),
            "scan.time = 12.500000 s: time goes backwards; allowed: at least 12.750000 s, the time "
            "of the scan before");
}

TEST(ScanCheckTest, RefusesEachCoordinateOfAPoint) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 1.1e7, -3e38}) {
    const auto value = static_cast<float>(bad);
    for (int axis = 0; axis < 3; ++axis) {
      for (const std::size_t i : {std::size_t{0}, std::size_t{7}, std::size_t{19}}) {
        const std::string place = "[" + std::to_string(i) + "] = (";
        EXPECT_EQ(refusal([&](Scan& s) { s.points[i][axis] = value; }).find("scan.points" + place),
                  0u);
        EXPECT_EQ(refusal([&](Scan& s) {
                    s.no_returns[i][axis] = value;
                  }).find("scan.no_returns" + place),
                  0u);
      }
    }
  }
}

TEST(ScanCheckTest, NamesTheFirstBadPointAndItsValue) {
  const std::string said = refusal([](Scan& s) {
    s.points[5] = {1, std::numeric_limits<float>::infinity(), -2};
    s.points[9].setConstant(std::numeric_limits<float>::quiet_NaN());
  });
  EXPECT_EQ(said, "scan.points[5] = (1, inf, -2): allowed: coordinates within +-1e7 m");
}

TEST(ScanCheckTest, RefusesPlaces) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 1.1e7, -1.1e7}) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::string uav = refusal([&](Scan& s) { s.T_world_uav.translation[axis] = bad; });
      EXPECT_EQ(uav.find("scan.T_world_uav.translation = ("), 0u) << uav;
      EXPECT_NE(uav.find(") m: allowed: coordinates within +-1e7 m"), std::string::npos);
      EXPECT_EQ(refusal([&](Scan& s) {
                  s.T_world_sensor.translation[axis] = bad;
                }).find("scan.T_world_sensor.translation = ("),
                0u);
    }
  }
}

TEST(ScanCheckTest, RefusesMatricesThatAreNoRotations) {
  for (int i = 0; i < 9; ++i) {
    EXPECT_NE(refusal([&](Scan& s) { s.T_world_uav.rotation(i / 3, i % 3) = kNan; }), "");
    EXPECT_NE(refusal([&](Scan& s) { s.T_world_sensor.rotation(i / 3, i % 3) = kInfinity; }), "");
    EXPECT_NE(refusal([&](Scan& s) { s.T_world_sensor.rotation(i / 3, i % 3) = -1.1; }), "");
  }
  EXPECT_NE(refusal([](Scan& s) { s.T_world_uav.rotation.setZero(); }), "");
  EXPECT_NE(refusal([](Scan& s) { s.T_world_uav.rotation.setOnes(); }), "");
  EXPECT_NE(refusal([](Scan& s) { s.T_world_sensor.rotation *= 1.01; }), "");
  EXPECT_EQ(refusal([](Scan& s) { s.T_world_sensor.rotation(2, 2) = -1; }),  // mirrored
            "scan.T_world_sensor.rotation = [1, 0, 0; 0, 1, 0; 0, 0, -1]: allowed: a rotation "
            "matrix: orthonormal within 0.001, determinant +1");
}

TEST(ScanCheckTest, TakesRotationsOfRoundedNumbers) {
  EXPECT_EQ(refusal([](Scan& s) {
              s.T_world_sensor.rotation << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
            }),
            "");
  EXPECT_EQ(refusal([](Scan& s) {
              s.T_world_uav.rotation << 0.7071, -0.7071, 0, 0.7071, 0.7071, 0, 0, 0, 1;
            }),
            "");
}

}  // namespace
}  // namespace ldm
