/// Drawn worlds keep their promises; simulations repeat bit for bit.
#include "datasets/scenario/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

/// A shipped scenario, cut to 20 s so that its world is drawn quickly.
Scenario short_scenario(const std::string& name) {
  Scenario scenario =
      read_scenario(tests::source_folder() / "datasets" / "scenarios" / (name + ".toml"));
  scenario.frames = 200;
  scenario.uav.waypoints = 5;
  return scenario;
}

bool same_bits(const ldm::Pose& a, const ldm::Pose& b) {
  return a.rotation == b.rotation && a.translation == b.translation;
}

/// Horizontal distance between the surfaces of the upright cylinders around two objects.
double gap(const Obstacle& a, const Obstacle& b, double t) {
  return (a.motion.at(t).position - b.motion.at(t).position).norm() - a.body.radius - b.body.radius;
}

/// Distance of p from the upright cylinder around an obstacle; negative inside.
double distance(const Obstacle& obstacle, const Eigen::Vector3d& p, double t) {
  const double beside =
      (p.head<2>() - obstacle.motion.at(t).position).norm() - obstacle.body.radius;
  const double middle = obstacle.bottom + obstacle.body.height / 2;
  const double above = std::abs(p.z() - middle) - obstacle.body.height / 2;
  if (beside > 0 && above > 0) return std::hypot(beside, above);
  return std::max(beside, above);
}

class WorldTest : public testing::TestWithParam<const char*> {};

TEST_P(WorldTest, NothingMeetsAtAnyTime) {
  const Scenario scenario = short_scenario(GetParam());
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const World world = draw_world(scenario, seed);
    const auto& obstacles = world.obstacles;
    for (double t = 0; t < scenario.duration(); t += 0.03) {
      const Eigen::Vector3d uav = world.path.position(t);
      for (std::size_t i = 0; i < obstacles.size(); ++i) {
        EXPECT_EQ(obstacles[i].id, static_cast<std::int32_t>(i));
        // The clearance is checked every 0.1 s; between checks a little may be missing.
        EXPECT_GT(distance(obstacles[i], uav, t), scenario.uav.clearance - 0.1);
        const Eigen::Array2d reach =
            obstacles[i].motion.at(t).position.array().abs() + obstacles[i].body.radius;
        EXPECT_TRUE((reach <= scenario.area.array() / 2 + 0.1).all());
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_GE(gap(obstacles[i], obstacles[j], t), scenario.obstacle_gap);
        }
      }
    }
  }
}

TEST_P(WorldTest, ObstaclesComeIntoTheMap) {
  const Scenario scenario = short_scenario(GetParam());
  Simulation simulation(scenario, 1);
  Frame frame;
  std::size_t inside = 0;
  while (simulation.next(frame)) {
    for (const ObjectState& object : frame.truth->objects) {
      const Eigen::Vector3d offset = object.position - frame.scan.T_world_uav.translation;
      inside += (offset.array().abs() < 2.4).all();
    }
  }
  EXPECT_GT(static_cast<double>(inside) / static_cast<double>(scenario.frames), 1);
}

TEST_P(WorldTest, FramesAreWhatTheyClaim) {
  Simulation simulation(short_scenario(GetParam()), 2, 30);
  EXPECT_EQ(simulation.size(), 30);
  Frame frame;
  std::int64_t index = 0;
  for (; simulation.next(frame); ++index) {
    EXPECT_EQ(frame.index, index);
    EXPECT_DOUBLE_EQ(frame.scan.time, static_cast<double>(index) / 10);
    EXPECT_EQ(frame.scan.points.size() + frame.scan.no_returns.size(), 16384u);
    EXPECT_EQ(frame.scan.points.size(), frame.truth->noise_free_hits.size());
    const ldm::Pose& pose = frame.scan.T_world_sensor;
    for (std::size_t i = 0; i < frame.scan.points.size(); i += 50) {
      const Eigen::Vector3d point = pose * frame.scan.points[i].cast<double>();
      EXPECT_LT((point.cast<float>() - frame.truth->noise_free_hits[i]).norm(), 6 * 0.02);
    }
  }
  EXPECT_EQ(index, 30);
  EXPECT_FALSE(simulation.next(frame));
}

INSTANTIATE_TEST_SUITE_P(Shipped, WorldTest, testing::Values("scenario1", "scenario2", "scenario3"),
                         [](const auto& test) { return std::string(test.param); });

TEST(SimulationTest, SameSeedSameBits) {
  const Scenario scenario = short_scenario("scenario3");
  Simulation one(scenario, 5, 20), again(scenario, 5, 20), other(scenario, 6, 20);
  Frame a, b, c;
  while (one.next(a)) {
    ASSERT_TRUE(again.next(b));
    ASSERT_TRUE(other.next(c));
    EXPECT_TRUE(same_bits(a.scan.T_world_sensor, b.scan.T_world_sensor));
    EXPECT_EQ(a.scan.points, b.scan.points);
    EXPECT_EQ(a.scan.no_returns, b.scan.no_returns);
    EXPECT_EQ(a.truth->noise_free_hits, b.truth->noise_free_hits);
    EXPECT_EQ(one.range_image().ranges, again.range_image().ranges);
    EXPECT_NE(one.range_image().ranges, other.range_image().ranges);
    EXPECT_FALSE(same_bits(a.scan.T_world_uav, c.scan.T_world_uav));
  }
}

TEST(SimulationTest, AScanIsMadeFromWhatALogStores) {
  Scenario scenario = short_scenario("scenario1");
  scenario.sensor.position = {0.1, 0, -0.05};
  scenario.sensor.roll_pitch_yaw = {0, 10, 90};
  Simulation simulation(scenario, 3, 5);
  Frame frame;
  while (simulation.next(frame)) {
    const ldm::Pose T_world_uav = to_pose(simulation.uav_pose());
    EXPECT_TRUE(same_bits(T_world_uav, frame.scan.T_world_uav));
    EXPECT_TRUE(
        same_bits(composed(T_world_uav, simulation.T_uav_sensor()), frame.scan.T_world_sensor));
    ldm::Scan scan;
    project(simulation.lidar(), simulation.range_image(), scan);
    EXPECT_EQ(scan.points, frame.scan.points);
    EXPECT_EQ(scan.no_returns, frame.scan.no_returns);
  }
}

/// The same returns in the sensor's frame, from places some millimetres off.
TEST(SimulationTest, ReportedPosesAreNoisy) {
  Scenario scenario = short_scenario("scenario3");
  Simulation exact(scenario, 3, 100);
  scenario.sensor.pose_sigma = 0.01;
  Simulation noisy(scenario, 3, 100);
  Frame a, b;
  double squares = 0;
  while (exact.next(a) && noisy.next(b)) {
    EXPECT_EQ(a.scan.points, b.scan.points);
    EXPECT_EQ(a.truth->noise_free_hits, b.truth->noise_free_hits);
    const Eigen::Vector3d off =
        b.scan.T_world_sensor.translation - a.scan.T_world_sensor.translation;
    EXPECT_LT((b.scan.T_world_uav.translation - a.scan.T_world_uav.translation - off).norm(),
              1e-12);
    squares += off.squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(squares / 300), 0.01, 0.0015);
}

TEST(SimulationTest, TheSensorLeavesTheWorldAlone) {
  Scenario scenario = short_scenario("scenario2");
  Simulation narrow(scenario, 4, 2);
  set_scenario_value(scenario, "sensor.channels", "64");
  set_scenario_value(scenario, "sensor.range_sigma_m", "0.1");
  Simulation fine(scenario, 4, 2);
  Frame a, b;
  ASSERT_TRUE(narrow.next(a) && fine.next(b));
  EXPECT_TRUE(same_bits(a.scan.T_world_uav, b.scan.T_world_uav));
  EXPECT_EQ(a.truth->objects[0].position, b.truth->objects[0].position);
  EXPECT_EQ(fine.range_image().channels, 64);
  EXPECT_GT(b.scan.points.size(), 3 * a.scan.points.size());
}

TEST(SimulationTest, ASingleChannelLooksAlongTheMiddle) {
  SensorDescription sensor;
  sensor.elevation = {-10, 30};
  sensor.range = {0.3, 100};
  sensor.channels = 1;
  EXPECT_DOUBLE_EQ(lidar_model(sensor).elevations.at(0), 10 * std::numbers::pi / 180);
  sensor.channels = 3;
  EXPECT_DOUBLE_EQ(lidar_model(sensor).elevations.at(2), 30 * std::numbers::pi / 180);
}

TEST(SimulationTest, RefusesWhatItCannotDo) {
  Scenario scenario = short_scenario("scenario1");
  EXPECT_THROW(Simulation(scenario, 1, 0), ldm::InvalidInput);
  EXPECT_THROW(Simulation(scenario, 1, 201), ldm::InvalidInput);
  scenario.sensor.channels = 0;
  EXPECT_THROW(Simulation(scenario, 1), ldm::InvalidInput);
}

TEST(SimulationTest, SaysWhenThereIsNoRoom) {
  Scenario scenario = short_scenario("scenario2");
  scenario.groups[0].count = 500;
  const std::string message =
      tests::message_of<std::runtime_error>([&] { draw_world(scenario, 9); });
  EXPECT_EQ(message.rfind("scenario scenario2, seed 9: no world in 20 attempts; the last: "
                          "no room for obstacle ",
                          0),
            0u)
      << message;
}

}  // namespace
}  // namespace datasets
