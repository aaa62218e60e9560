/// Scenario files: what ships can be read, and what is wrong is named with its line.
#include "datasets/scenario/scenario.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

const std::filesystem::path kFolder = tests::source_folder() / "datasets" / "scenarios";

Scenario shipped(const std::string& name) {
  return read_scenario(kFolder / (name + ".toml"));
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What reading a shipped scenario says after one line of it was replaced.
std::string error_with(const std::string& line, const std::string& replacement,
                       const std::string& name = "scenario1") {
  std::string text = text_of(kFolder / (name + ".toml"));
  const std::size_t at = text.find(line);
  EXPECT_NE(at, std::string::npos);
  text.replace(at, line.size(), replacement);
  const tests::TextFile file("scenario.toml", text);
  const std::string message =
      tests::message_of<ldm::InvalidInput>([&] { read_scenario(file.path()); });
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_EQ(message.rfind(file.name() + ':', 0), 0u) << message;
  const std::size_t after_line = message.find(": ");
  return message.substr(std::min(message.size(), after_line + 2));
}

TEST(ScenarioTest, WhatMovesIsAsInThePaper) {
  const auto kinds = [](const Scenario& scenario) {
    std::set<ObstacleMotionKind> result;
    for (const ObstacleGroup& group : scenario.groups) {
      if (group.count > 0) result.insert(group.motion);
    }
    return result;
  };
  using Kinds = std::set<ObstacleMotionKind>;
  EXPECT_EQ(kinds(shipped("scenario1")), Kinds{ObstacleMotionKind::kShuttle});
  EXPECT_EQ(kinds(shipped("scenario2")), Kinds{ObstacleMotionKind::kStatic});
  EXPECT_EQ(kinds(shipped("scenario3")),
            (Kinds{ObstacleMotionKind::kStatic, ObstacleMotionKind::kShuttle}));
}

TEST(ScenarioTest, TheSensorIsThePapers) {
  for (const char* name : {"scenario1", "scenario2", "scenario3"}) {
    const Scenario scenario = shipped(name);
    EXPECT_EQ(scenario.name, name);
    EXPECT_EQ(scenario.frames, 1200);
    EXPECT_EQ(scenario.duration(), 120);
    EXPECT_EQ(scenario.sensor.channels, 16);
    EXPECT_EQ(scenario.sensor.azimuths, 1024);
    EXPECT_EQ(scenario.sensor.rate, 10);
    EXPECT_EQ(scenario.sensor.elevation.min, -16.6);
    EXPECT_EQ(scenario.sensor.elevation.max, 16.6);
  }
}

TEST(ScenarioTest, SetsAnyValueItLists) {
  Scenario scenario = shipped("scenario3");
  for (const auto& [name, value] : scenario_values(shipped("scenario3"))) {
    EXPECT_NO_THROW(set_scenario_value(scenario, name, value)) << name;
  }
  EXPECT_EQ(scenario_values(scenario), scenario_values(shipped("scenario3")));

  set_scenario_value(scenario, "sensor.channels", "64");
  EXPECT_EQ(scenario.sensor.channels, 64);
  set_scenario_value(scenario, "obstacles.speed_scale", "2.5");
  EXPECT_EQ(scenario.speed_scale, 2.5);
  set_scenario_value(scenario, "groups.boxes.width_m", "0.5,0.75");
  EXPECT_EQ(scenario.groups[0].width.max, 0.75);
}

TEST(ScenarioTest, RefusesToSetWhatIsWrongAndChangesNothing) {
  Scenario scenario = shipped("scenario3");
  const auto error = [&scenario](const char* name, const char* text) {
    return tests::message_of<ldm::InvalidInput>([&] { set_scenario_value(scenario, name, text); });
  };
  EXPECT_EQ(error("sensor.channels", "0"), "sensor.channels = 0: allowed: an integer in [1, 1024]");
  EXPECT_EQ(error("sensor.channels", "16.5"),
            "sensor.channels = 16.5: allowed: an integer in [1, 1024]");
  EXPECT_EQ(error("sensor.range_sigma_m", "nan"),
            "sensor.range_sigma_m = nan: allowed: a number in [0, 10]");
  EXPECT_EQ(error("sensor.range_sigma_m", "0.1x"),
            "sensor.range_sigma_m = 0.1x: allowed: a number in [0, 10]");
  EXPECT_EQ(error("sensor.rate_hz", ""), "sensor.rate_hz = : allowed: a number in [0.1, 1000]");
  EXPECT_EQ(error("area.size_m", "5"), "area.size_m = 5: allowed: 2 numbers in [1, 1000]");
  EXPECT_EQ(error("uav.leg_m", "3,2"),
            "uav.leg_m = 3,2: allowed: two numbers, the smaller first, in [0, 1000]");
  EXPECT_EQ(error("groups.boxes.shape", "ball"),
            "groups.boxes.shape = ball: allowed: one of box, cylinder, person, walker");
  EXPECT_EQ(error("speed", "1"), "speed = 1: allowed: a key that scenarios have");
  // A group at rest has no speed, so it cannot be set in motion.
  EXPECT_EQ(error("groups.boxes.motion", "shuttle"),
            "groups.boxes.legs = 0,0: allowed: two numbers, the smaller first, in [1, 100]");
  EXPECT_EQ(scenario_values(scenario), scenario_values(shipped("scenario3")));
}

TEST(ScenarioTest, NamesWhatIsWrongInAFile) {
  EXPECT_EQ(error_with("channels = 16", "channels = \"16\""),
            "sensor.channels = \"16\": allowed: an integer in [1, 1024]");
  EXPECT_EQ(error_with("channels = 16", "channels = true"),
            "sensor.channels = true: allowed: an integer in [1, 1024]");
  EXPECT_EQ(error_with("channels = 16", "channels = 2000"),
            "sensor.channels = 2000: allowed: an integer in [1, 1024]");
  EXPECT_EQ(error_with("channels = 16", "chanels = 16"),
            "sensor.chanels = 16: allowed: a key that scenarios have; did you mean "
            "sensor.channels?");
  EXPECT_EQ(error_with("channels = 16", ""),
            "missing: sensor.channels = : allowed: an integer in [1, 1024]");
  EXPECT_EQ(error_with("shape = \"box\"", ""),
            "groups.moving_boxes.shape is missing: allowed: one of box, cylinder, person, walker");
  EXPECT_EQ(error_with("frames = 1200", "frames = 0"),
            "frames = 0: allowed: an integer in [1, 1000000]");
  EXPECT_EQ(error_with("gap_m = ", "gap_m = -"),
            "obstacles.gap_m = -0.3: allowed: a number in [0, 100]");
  EXPECT_EQ(error_with("motion = \"shuttle\"", "motion = \"dance\""),
            "groups.moving_boxes.motion = \"dance\": allowed: one of static, shuttle, timetable");
  EXPECT_EQ(error_with("motion = \"shuttle\"", "motion = \"static\""),
            "groups.moving_boxes.legs = 1,2: allowed: a key that scenarios have");
  EXPECT_EQ(error_with("[groups.moving_boxes]", "[groups.\"moving boxes\"]"),
            "groups.moving boxes = {...}: allowed: a name of letters, digits and _");
  EXPECT_EQ(error_with("title = ", "title = 5 #"), "title = 5: allowed: text");
}

TEST(ScenarioTest, NamesWhatIsWrongInATimetable) {
  const auto error = [](const std::string& line, const std::string& replacement) {
    return error_with(line, replacement, "outdoor2");
  };
  const std::string person = "timetable_s_m = [[3, 1.2, -3.7], [13, 1.2, 4.3]";
  const std::string stops =
      "allowed: stops [time, x, y], times ascending from 0 or later, places "
      "in [-500, 500]";
  const std::string rest = ",15,1.2,4.3,25,1.2,-3.7: ";
  EXPECT_EQ(error(person, "timetable_s_m = [[3, 1.2, -3.7], [3, 1.2, 4.3]"),
            "groups.person.timetable_s_m = 3,1.2,-3.7,3,1.2,4.3" + rest + stops);
  EXPECT_EQ(error(person, "timetable_s_m = [[3, 1.2, -3.7], [13, 1.2]"),
            "groups.person.timetable_s_m = 3,1.2,-3.7,13,1.2" + rest + stops);
  EXPECT_EQ(error(person, "timetable_s_m = [[-3, 1.2, -3.7], [13, 1.2, 4.3]"),
            "groups.person.timetable_s_m = -3,1.2,-3.7,13,1.2,4.3" + rest + stops);
  EXPECT_EQ(error(person, "timetable_s_m = [[3, 1.2, -3.7], [13, 1.2, 900]"),
            "groups.person.timetable_s_m = 3,1.2,-3.7,13,1.2,900" + rest + stops);
  EXPECT_EQ(error("spread_m = 0.1\nlateness_s = 0.2", "spread_m = 0.1\nlateness_s = 2"),
            "groups.person.timetable_s_m = 3,1.2,-3.7,13,1.2,4.3" + rest +
                "allowed: stops more than twice lateness_s from one another");
  EXPECT_EQ(error("acceleration_mps2 = [0.8", "acceleration_mps2 = [0.1")
                .rfind("groups.person.acceleration_mps2 = 0.1,1.2: allowed: at least 0.35", 0),
            0u);
  EXPECT_EQ(error("stride_m = [1.1, 1.3]", ""),
            "missing: groups.person.stride_m = : allowed: two numbers, the smaller first, in "
            "[0.2, 3]");
  EXPECT_EQ(error("shape = \"walker\"", "shape = \"person\""),
            "groups.person.stride_m = 1.1,1.3: allowed: a key that scenarios have");
  EXPECT_EQ(error("drift_m = 0.03", "waypoints = 5"),
            "uav.waypoints = 5: allowed: a key that scenarios have");
  EXPECT_EQ(error("[13, 0, 3.5, 1.1]", "[13, 0, 3.5]"),
            "uav.timetable_s_m = 3,0,-4.5,1.1,13,0,3.5,15,0,3.5,1.1,25,0,-4.5,1.1: allowed: stops "
            "[time, x, y, z], times ascending from 0 or later, places in [-500, 500]");
}

TEST(ScenarioTest, TimetablesReadBackFromTheirText) {
  for (const char* name : {"outdoor1", "outdoor2"}) {
    Scenario scenario = shipped(name);
    for (const auto& [key, value] : scenario_values(shipped(name))) {
      EXPECT_NO_THROW(set_scenario_value(scenario, key, value)) << key;
    }
    EXPECT_EQ(scenario_values(scenario), scenario_values(shipped(name)));
  }
}

TEST(ScenarioTest, NamesTheLine) {
  const tests::TextFile file("line.toml", "title = \"x\"\nframes = -1\n[groups]\n");
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { read_scenario(file.path()); }),
            file.name() + ":2: frames = -1: allowed: an integer in [1, 1000000]");
}

TEST(ScenarioTest, ATruncatedFileIsRefused) {
  const std::string text = text_of(kFolder / "scenario3.toml");
  std::size_t refused = 0;
  for (std::size_t size = 0; size < text.size(); size += 7) {
    // Cut between two groups, the file is one of fewer groups, and complete.
    const std::size_t next = std::min(text.find_first_not_of('\n', size), text.size());
    if (next == text.size() || text.compare(next, 7, "[groups") == 0) continue;
    const tests::TextFile file("cut.toml", text.substr(0, size));
    EXPECT_THROW(read_scenario(file.path()), ldm::InvalidInput) << size;
    ++refused;
  }
  EXPECT_GT(refused, 100u);
}

TEST(ScenarioTest, AMissingFileIsRefused) {
  EXPECT_THROW(read_scenario(kFolder / "scenario0.toml"), ldm::InvalidInput);
}

TEST(ScenarioTest, TheHashesOfThePublishedStudyStay) {
  EXPECT_EQ(scenario_hash(shipped("scenario1")), "7ca7417d918217a3");
  EXPECT_EQ(scenario_hash(shipped("scenario2")), "e88d6e1942472fbc");
  EXPECT_EQ(scenario_hash(shipped("scenario3")), "fb908b09d7036039");
}

TEST(ScenarioTest, TheHashTellsDescriptionsApart) {
  Scenario scenario = shipped("scenario1");
  const std::string hash = scenario_hash(scenario);
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(hash, scenario_hash(shipped("scenario1")));
  EXPECT_NE(hash, scenario_hash(shipped("scenario2")));
  scenario.title = "another";
  EXPECT_EQ(hash, scenario_hash(scenario));
  set_scenario_value(scenario, "sensor.pose_sigma_m", "0.01");
  EXPECT_NE(hash, scenario_hash(scenario));
  set_scenario_value(scenario, "sensor.pose_sigma_m", "0");
  EXPECT_EQ(hash, scenario_hash(scenario));
  set_scenario_value(scenario, "sensor.range_sigma_m", "0.021");
  EXPECT_NE(hash, scenario_hash(scenario));
}

}  // namespace
}  // namespace datasets
