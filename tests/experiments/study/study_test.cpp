#include "experiments/study/study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "experiments/avoidance/flight_study.h"
#include "experiments/study/seeds.h"
#include "tests/source_folder.h"
#include "tests/temporary_folder.h"

namespace experiments {
namespace {

const DataFolders kShipped{tests::source_folder().string()};

const std::string kBase =
    "title = \"T\"\n"                               // line 1
    "scenarios = [\"scenario1\", \"scenario3\"]\n"  // line 2
    "methods = [\"ldm\", \"circular_buffer\"]\n"    // line 3
    "seeds = 2\n"                                   // line 4
    "frames = 20\n";                                // line 5

Study study_of(const std::string& text, const StudyOptions& options = {}) {
  const tests::TemporaryFolder folder;
  return read_study(folder.write("tiny.toml", text), kShipped.scenarios, options);
}

std::string error_of(const std::string& text, const StudyOptions& options = {}) {
  std::string message = tests::message_of([&] { study_of(text, options); });
  return message.substr(std::min(message.size(), message.find("tiny.toml")));
}

/// Each with its own line in `kBase` replaced.
std::string with_line(int number, const std::string& line) {
  std::string text = kBase;
  std::size_t begin = 0;
  for (int i = 1; i < number; ++i) begin = text.find('\n', begin) + 1;
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

TEST(Study, ExpandsReplicateByReplicate) {
  const Study study = study_of(kBase);
  std::vector<std::string> ids;
  for (const Trial& trial : trials(study)) ids.push_back(trial_id(study, trial));
  EXPECT_EQ(ids,
            (std::vector<std::string>{"scenario1.ldm.s001", "scenario1.circular_buffer.s001",
                                      "scenario3.ldm.s001", "scenario3.circular_buffer.s001",
                                      "scenario1.ldm.s002", "scenario1.circular_buffer.s002",
                                      "scenario3.ldm.s002", "scenario3.circular_buffer.s002"}));
  EXPECT_EQ(study.trial_count(), ids.size());
}

TEST(Study, SweepPointsAreInTheId) {
  const Study study = study_of(
      kBase + "[sweep.axes]\n\"particles.count\" = [10, 20]\n\"map.voxels\" = [8, 16, 32]\n");
  EXPECT_EQ(study.trial_count(), 48u);
  EXPECT_EQ(trial_id(study, trials(study)[2]), "scenario1.ldm.p02.s001");
}

TEST(Study, TakesMethodsInsteadOfItsOwn) {
  // `octomap` uses no particles: held against the others, it is the same at every point.
  const Study study = study_of(kBase + "[sweep.axes]\n\"particles.count\" = [10, 20]\n",
                               {.seeds = 1, .frames = {}, .methods = {"octomap"}});
  EXPECT_EQ(study.trial_count(), 4u);
  EXPECT_EQ(trial_id(study, trials(study)[1]), "scenario1.octomap.p02.s001");
  EXPECT_EQ(tests::message_of([] {
              study_of(kBase, {.seeds = {}, .frames = {}, .methods = {"moon"}});
            }).rfind("--method: unknown method moon: allowed: ldm, ", 0),
            0u);
}

TEST(Study, IdsRoundTrip) {
  const Study study = study_of(kBase + "[sweep.axes]\n\"particles.count\" = [10, 20]\n");
  std::set<std::string> ids;
  for (const Trial& trial : trials(study)) {
    const std::string id = trial_id(study, trial);
    EXPECT_TRUE(ids.insert(id).second) << id;
    const Trial found = find_trial(study, id);
    EXPECT_EQ(std::tie(found.scenario, found.entrant, found.point, found.replicate),
              std::tie(trial.scenario, trial.entrant, trial.point, trial.replicate));
  }
  EXPECT_NE(tests::message_of([&] {
              find_trial(study, "scenario1.ldm.p03.s001");
            }).find("study tiny has no trial scenario1.ldm.p03.s001"),
            std::string::npos);
}

TEST(Study, LaterValuesWin) {
  const Study study =
      study_of(kBase +
               "[set]\n\"particles.count\" = 100\n\"particles.sigma_xy_mps\" = "
               "0.1\n\"survival.shadow\" = 0.5\n"
               "[sweep.axes]\n\"particles.sigma_xy_mps\" = [0.3]\n"
               "[[variant]]\nname = \"v\"\nmethod = \"ldm\"\nset = {\"particles.count\" = 50, "
               "\"particles.sigma_xy_mps\" = 0.2}\n");
  const auto parameters = [&](const char* id) {
    return trial_parameters(study, find_trial(study, id));
  };
  EXPECT_EQ(parameters("scenario1.ldm.p01.s001").particles.count, 100);
  EXPECT_EQ(parameters("scenario1.v.p01.s001").particles.count, 50);
  EXPECT_EQ(parameters("scenario1.v.p01.s001").particles.sigma_xy, 0.3);
  EXPECT_EQ(parameters("scenario1.v.p01.s001").survival.shadow, 0.5);
}

TEST(Study, ScenarioValuesReachTheScenario) {
  const Study study = study_of(kBase +
                               "[set]\n\"scenario.sensor.channels\" = 8\n"
                               "[sweep.axes]\n\"scenario.sensor.range_sigma_m\" = [0.01, 0.05]\n");
  const Trial trial = find_trial(study, "scenario3.ldm.p02.s001");
  const datasets::Scenario scenario = scenario_at(study, trial.scenario, trial.point);
  EXPECT_EQ(scenario.sensor.channels, 8);
  EXPECT_EQ(scenario.sensor.range_sigma, 0.05);
}

TEST(Study, FilterSeedsDifferBetweenAllTrials) {
  const Study study = study_of(kBase + "[sweep.axes]\n\"particles.count\" = [10, 20]\n");
  std::set<std::uint64_t> seeds;
  for (const Trial& trial : trials(study)) {
    seeds.insert(trial_parameters(study, trial).execution.seed);
  }
  // Scenarios share it: their worlds differ anyway.
  EXPECT_EQ(seeds.size(), trials(study).size() / study.scenarios.size());
}

TEST(Study, AGrowingSweepKeepsTheSeedsOfItsPoints) {
  const Study few = study_of(kBase + "[sweep.axes]\n\"particles.count\" = [20]\n");
  const Study more = study_of(kBase + "[sweep.axes]\n\"particles.count\" = [10, 20]\n");
  EXPECT_EQ(trial_parameters(few, find_trial(few, "scenario1.ldm.p01.s001")).execution.seed,
            trial_parameters(more, find_trial(more, "scenario1.ldm.p02.s001")).execution.seed);
}

TEST(Study, OptionsReplaceSeedsAndFrames) {
  const Study study = study_of(kBase, {.seeds = 7, .frames = 3});
  EXPECT_EQ(study.seeds, 7);
  EXPECT_EQ(study.frames, 3);
}

/// The shortest of five: reading a study of 200 trials a seed and naming all its trials [s].
double seconds_to_list(int seeds) {
  double shortest = 1e9;
  for (int repetition = 0; repetition < 5; ++repetition) {
    const auto began = std::chrono::steady_clock::now();
    const Study study =
        study_of(with_line(4, "seeds = " + std::to_string(seeds)) +
                 "[sweep.axes]\n\"particles.count\" = {from = 100, to = 5000, steps = 50}\n");
    std::size_t letters = 0;
    for (const Trial& trial : trials(study)) letters += trial_id(study, trial).size();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
    EXPECT_EQ(study.trial_count(), 200u * static_cast<std::size_t>(seeds));
    EXPECT_GT(letters, study.trial_count() * 20);
    shortest = std::min(shortest, elapsed.count());
  }
  return shortest;
}

TEST(Study, TenThousandTrialsListInATimeThatGrowsWithTheirNumber) {
  EXPECT_LT(seconds_to_list(50), 40 * seconds_to_list(5));  // 10 times; quadratic would be 100
}

TEST(Study, ShippedStudiesAreGood) {
  for (const std::string& name : kShipped.studies.names()) {
    const std::filesystem::path file = kShipped.studies.file(name);
    if (is_flight_study(file)) continue;  // flight_study_test.cpp
    EXPECT_GT(read_study(file, kShipped.scenarios).trial_count(), 0u) << name;
  }
  const Study table1 = read_study(kShipped.studies.file("table1"), kShipped.scenarios);
  EXPECT_EQ(table1.frames, 1200);
  EXPECT_EQ(table1.trial_count(), 270u);
}

TEST(StudyErrors, OfTheOutermostKeys) {
  EXPECT_EQ(error_of(with_line(1, "")), "tiny.toml:1: title is missing: allowed: text");
  EXPECT_EQ(error_of(with_line(4, "seeds = 0")),
            "tiny.toml:4: seeds = 0: allowed: an integer in [1, 100000]");
  EXPECT_EQ(error_of(with_line(5, "frames = 1.5")),
            "tiny.toml:5: frames = 1.5: allowed: an integer in [1, 1000000]");
  EXPECT_NE(error_of(kBase + "series = 1\n").find("tiny.toml:6: series = 1"), std::string::npos);
  EXPECT_NE(error_of(kBase + "sweeps = 1\n").find("tiny.toml:6: sweeps"), std::string::npos);
  EXPECT_NE(error_of("title = ").find("tiny.toml:1: not TOML"), std::string::npos);
}

TEST(StudyErrors, OfScenarios) {
  EXPECT_NE(error_of(with_line(2, "scenarios = [\"moon\"]"))
                .find("tiny.toml:2: unknown scenario moon: allowed: a .toml file, outdoor1"),
            std::string::npos);
  EXPECT_NE(error_of(with_line(2, "scenarios = [\"scenario1\", \"scenario1\"]"))
                .find("tiny.toml:2: scenario1 comes twice"),
            std::string::npos);
  EXPECT_NE(error_of(with_line(2, "scenarios = []")).find("tiny.toml:2: scenarios = []"),
            std::string::npos);
}

TEST(StudyErrors, OfMethodsAndVariants) {
  EXPECT_NE(error_of(with_line(3, "methods = [\"kalman\"]"))
                .find("tiny.toml:3: unknown method kalman: allowed: ldm"),
            std::string::npos);
  EXPECT_NE(error_of(with_line(3, "")).find("methods: allowed: at least one"), std::string::npos);
  EXPECT_NE(
      error_of(with_line(3, "methods = [\"ldm\", \"ldm\"]")).find("tiny.toml:3: ldm comes twice"),
      std::string::npos);
  const std::string variant = kBase + "[[variant]]\nmethod = \"circular_buffer\"\n";
  EXPECT_NE(error_of(variant + "name = \"a.b\"\nset = {}\n").find("tiny.toml:8: name \"a.b\""),
            std::string::npos);
  EXPECT_NE(error_of(variant + "name = \"v\"\n").find("tiny.toml:6"), std::string::npos);
  EXPECT_NE(error_of(variant + "name = \"v\"\nset = {\"particles.count\" = 5}\n")
                .find("tiny.toml:9: particles.count = 5: allowed: parameters that circular_buffer"),
            std::string::npos);
  EXPECT_NE(error_of(variant + "name = \"v\"\nset = {\"scenario.sensor.channels\" = 8}\n")
                .find("tiny.toml:9: unknown parameter scenario.sensor.channels"),
            std::string::npos);
}

TEST(StudyErrors, OfValues) {
  EXPECT_NE(error_of(kBase + "[set]\n\"map.resolution_m\" = 0\n")
                .find("tiny.toml:7: map.resolution_m = 0: allowed: a number from 0.01 to 10 m"),
            std::string::npos);
  EXPECT_NE(error_of(kBase + "[set]\n\"map.colour\" = 0\n")
                .find("tiny.toml:7: unknown parameter map.colour"),
            std::string::npos);
  EXPECT_NE(error_of(kBase + "[set]\n\"execution.seed\" = 3\n").find("tiny.toml:7: execution.seed"),
            std::string::npos);
  EXPECT_NE(error_of(with_line(3, "methods = [\"octomap\"]") + "[set]\n\"particles.count\" = 3\n")
                .find("tiny.toml:7: particles.count = 3: allowed: parameters that a method"),
            std::string::npos);
  EXPECT_NE(error_of(kBase + "[sweep.axes]\n\"particles.count\" = [10, -1]\n")
                .find("tiny.toml:7: particles.count = -1"),
            std::string::npos);
  EXPECT_NE(error_of(kBase + "[sweep.axes]\n\"scenario.sensor.colour\" = [1]\n")
                .find("tiny.toml:7: scenario: "),
            std::string::npos);
  EXPECT_NE(tests::message_of([] {
              study_of(kBase, {.seeds = {}, .frames = 5000});
            }).find("frames = 5000: allowed: at most the 1200 of scenario1"),
            std::string::npos);
}

}  // namespace
}  // namespace experiments
