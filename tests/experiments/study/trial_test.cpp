#include "experiments/study/trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "experiments/study/seeds.h"
#include "tests/temporary_folder.h"

namespace experiments {
namespace {

const char kTiny[] =
    "title = \"tiny\"\nscenarios = [\"scenario1\"]\nmethods = [\"ldm\", \"circular_buffer\"]\n"
    "seeds = 2\nframes = 24\nseries = true\n"
    "[set]\n\"particles.count\" = 2000\n\"map.voxels\" = 24\n"
    "[sweep.axes]\n\"map.resolution_m\" = [0.2, 0.3]\n";

/// A method whose map is none: its trials fail at the first frame.
class Breaks : public ldm::Mapper {
 public:
  void update(const ldm::Scan&, ldm::StageListener*) override {}
  void read(ldm::LocalMap&) const override {}
};

TrialRecord run_trial(const TrialRequest& request) {
  TrialRecord found;
  run_trials(request, {request.id}, [&](const TrialRecord& record) { found = record; });
  return found;
}

class TrialOfATinyStudy : public testing::Test {
 protected:
  TrialRequest request(const std::string& id) {
    return {.study = folder_.write("tiny.toml", kTiny).string(),
            .id = id,
            .options = {},
            .serial = false,
            .failure = {},
            .data_dir = {}};
  }
  /// The record's text up to its timing.
  std::string record_text(const TrialRecord& record) {
    write_record(record, folder_.path() / "record.json");
    const std::string text = folder_.read("record.json");
    return text.substr(0, text.find("\n \"timing\""));
  }
  std::string series_text(const TrialRecord& record) {
    write_record(record, folder_.path() / "record.json");
    return folder_.read("record.series.json");
  }

  tests::TemporaryFolder folder_;
};

TEST_F(TrialOfATinyStudy, RemadeIsTheSameButForTheTiming) {
  const std::string first = record_text(run_trial(request("scenario1.ldm.p01.s001")));
  const std::string second = record_text(run_trial(request("scenario1.ldm.p01.s001")));
  EXPECT_EQ(first, second);
  EXPECT_NE(first.find("\"status\": \"ok\""), std::string::npos);
  EXPECT_NE(first.find("\"point\": {\"map.resolution_m\":0.2}"), std::string::npos);
  EXPECT_NE(first.find("\"map.voxels\":[24,24,24]"), std::string::npos);
  EXPECT_EQ(first.find("\"series\": "), std::string::npos);
}

TEST_F(TrialOfATinyStudy, HasItsSeriesBesideTheRecordWhichKnowsTheirLength) {
  const TrialRecord record = run_trial(request("scenario1.ldm.p01.s001"));
  const std::string series = series_text(record);
  EXPECT_NE(series.find("\"series\": [{\"object\":"), std::string::npos);
  EXPECT_NE(record_text(record).find("\"series_bytes\": " + std::to_string(series.size()) + ","),
            std::string::npos);
}

TEST_F(TrialOfATinyStudy, NamesTheFilesItWasMadeFrom) {
  const TrialRecord record = run_trial(request("scenario1.ldm.p01.s001"));
  ASSERT_EQ(record.files.size(), 2u);
  EXPECT_EQ(record.files[0].path, std::filesystem::canonical(folder_.path() / "tiny.toml"));
  EXPECT_EQ(record.files[1].path, "datasets/scenarios/scenario1.toml");
  EXPECT_EQ(record.files[1].hash.size(), 16u);
  EXPECT_NE(record_text(record).find("\"datasets/scenarios/scenario1.toml\":\"" +
                                     record.files[1].hash + "\""),
            std::string::npos);

  folder_.write("tiny.toml", std::string(kTiny) + "# a remark\n");
  const DataFolders folders{std::optional<std::string>{}};
  const Study changed = read_study(folder_.path() / "tiny.toml", folders.scenarios);
  EXPECT_NE(changed.file.hash, record.files[0].hash);
  EXPECT_EQ(changed.scenario_files.front().hash, record.files[1].hash);
}

TEST_F(TrialOfATinyStudy, ThatEndedBadlyIsRecordedWithoutBeingRun) {
  TrialRequest crashed = request("scenario1.ldm.p01.s001");
  crashed.failure = "killed by SIGSEGV";
  const std::string text = record_text(run_trial(crashed));
  EXPECT_NE(text.find("\"status\": \"failed\",\n \"error\": \"killed by SIGSEGV\",\n \"command\": "
                      "\"ldm trial "),
            std::string::npos);
  EXPECT_NE(text.find("\"method\": \"ldm\""), std::string::npos);
  EXPECT_EQ(text.find("\"scores\""), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "record.series.json"));
}

TEST_F(TrialOfATinyStudy, NeitherSeedsNorSerialChangeIt) {
  TrialRequest longer = request("scenario1.ldm.p01.s001");
  longer.options.seeds = 99;
  longer.serial = true;
  EXPECT_EQ(record_text(run_trial(longer)),
            record_text(run_trial(request("scenario1.ldm.p01.s001"))));
}

TEST_F(TrialOfATinyStudy, SeesTheWorldOfItsReplicateWhateverMethodAndPoint) {
  const TrialRecord ldm = run_trial(request("scenario1.ldm.p01.s001"));
  const TrialRecord other = run_trial(request("scenario1.circular_buffer.p02.s001"));
  const TrialRecord second = run_trial(request("scenario1.ldm.p01.s002"));
  EXPECT_EQ(ldm.scenario_seed, scenario_seed("scenario1", 1));
  EXPECT_EQ(ldm.scenario_seed, other.scenario_seed);
  EXPECT_NE(ldm.scenario_seed, second.scenario_seed);
  EXPECT_NE(ldm.filter_seed, other.filter_seed);
  EXPECT_EQ(ldm.parameters.execution.seed, ldm.filter_seed);
}

TEST_F(TrialOfATinyStudy, TellsTheTracksOfPeopleWhileOneIsHidden) {
  TrialRequest outdoor = request("outdoor1.ldm.s001");
  outdoor.study = folder_
                      .write("people.toml",
                             "title = \"people\"\nscenarios = [\"outdoor1\"]\n"
                             "methods = [\"ldm\"]\nseeds = 1\nframes = 150\nseries = true\n"
                             "[set]\n\"particles.count\" = 20000\n")
                      .string();
  const std::vector<VelocitySeries> people = run_trial(outdoor).evaluation.series;
  ASSERT_EQ(people.size(), 3u);
  const auto hidden = [&](std::size_t k) {
    return std::count(people[k].visible.begin(), people[k].visible.end(), false);
  };
  EXPECT_EQ(hidden(0), 0);
  EXPECT_EQ(hidden(1), 0);
  EXPECT_GE(hidden(2), 2);
  for (const VelocitySeries& person : people) {
    EXPECT_EQ(person.track.size(), person.frame.size());
    EXPECT_EQ(person.track[30].has_value(), person.velocity[30].has_value());
  }
  EXPECT_NE(people[1].track[30], people[2].track[30]);
  const TrialRecord record = run_trial(outdoor);
  EXPECT_NE(series_text(record).find("\"visible\":[true,"), std::string::npos);
  EXPECT_EQ(record_text(record).find("\"occlusions_kept_pct\":null"), std::string::npos);
}

TEST_F(TrialOfATinyStudy, AMethodWithoutClustersHasNoVelocityScores) {
  const std::string text = record_text(run_trial(request("scenario1.circular_buffer.p01.s001")));
  EXPECT_NE(text.find("\"dynamic_velocity_error_mps\":null"), std::string::npos);
  EXPECT_NE(text.find("\"objects_missed_pct\":null"), std::string::npos);
  EXPECT_NE(text.find("\"clusters_without_object_per_frame\":null"), std::string::npos);
  EXPECT_NE(text.find("\"tracks_per_stay\":null"), std::string::npos);
  EXPECT_NE(text.find("\"series_bytes\": 0,"), std::string::npos);
  EXPECT_EQ(text.find("\"accuracy_pct\":null"), std::string::npos);
}

TEST_F(TrialOfATinyStudy, TimesTheFramesAfterTheWarmUp) {
  TrialRequest serial = request("scenario1.ldm.p01.s001");
  serial.serial = true;
  write_record(run_trial(serial), folder_.path() / "record.json");
  const std::string text = folder_.read("record.json");
  EXPECT_NE(text.find("\"timing\": {\"serial\":true,\"frames\":14,"), std::string::npos);
  EXPECT_NE(text.find("\"update_time_samples_ms\":["), std::string::npos);
  EXPECT_NE(text.find("\"stages_ms\":{\"occupancy_prediction\":{\"median\":"), std::string::npos);
}

TEST_F(TrialOfATinyStudy, ThatFailsSaysSoInItsRecord) {
  TrialRequest crowded = request("scenario1.ldm.s001");
  crowded.study = folder_
                      .write("crowded.toml",
                             "title = \"no room\"\nscenarios = [\"scenario1\"]\n"
                             "methods = [\"ldm\"]\nseeds = 1\nframes = 5\n"
                             "[set]\n\"scenario.area.size_m\" = [1, 1]\n")
                      .string();
  const TrialRecord record = run_trial(crowded);
  ASSERT_TRUE(record.error);
  const std::string text = record_text(record);
  EXPECT_NE(text.find("\"status\": \"failed\",\n \"error\": \""), std::string::npos);
  EXPECT_NE(text.find("\"command\": \"ldm trial "), std::string::npos);
  EXPECT_EQ(text.find("\"scores\""), std::string::npos);
}

TEST_F(TrialOfATinyStudy, SharesItsWorldWithOthersAndIsTheSame) {
  const std::vector<std::string> ids = {
      "scenario1.ldm.p01.s001", "scenario1.circular_buffer.p02.s001", "scenario1.ldm.p02.s002"};
  std::vector<std::string> found;
  run_trials(request(""), ids, [&](const TrialRecord& record) {
    EXPECT_EQ(record.id, ids[found.size()]);
    found.push_back(record_text(record));
  });
  ASSERT_EQ(found.size(), ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(found[i], record_text(run_trial(request(ids[i]))));
  }
}

TEST_F(TrialOfATinyStudy, RefusesAnUnknownIdBeforeTheFirstRuns) {
  int ran = 0;
  EXPECT_THROW(run_trials(request(""), {"scenario1.ldm.p01.s001", "scenario1.ldm.p99.s001"},
                          [&](const TrialRecord&) { ++ran; }),
               ldm::InvalidInput);
  EXPECT_EQ(ran, 0);
}

TEST_F(TrialOfATinyStudy, ThatFailsLeavesTheOthersInItsWorldAlone) {
  add_methods({{.name = "breaks",
                .help = "writes no map",
                .parameters = {"map"},
                .create = [](const ldm::Parameters&) -> std::unique_ptr<ldm::Mapper> {
                  return std::make_unique<Breaks>();
                }}});
  TrialRequest breaking = request("");
  breaking.study = folder_
                       .write("breaking.toml",
                              "title = \"breaking\"\nscenarios = [\"scenario1\"]\nseeds = 1\n"
                              "methods = [\"breaks\", \"circular_buffer\"]\nframes = 5\n")
                       .string();
  std::vector<bool> failed;
  run_trials(breaking, {"scenario1.breaks.s001", "scenario1.circular_buffer.s001"},
             [&](const TrialRecord& record) { failed.push_back(record.error.has_value()); });
  EXPECT_EQ(failed, std::vector<bool>({true, false}));
}

}  // namespace
}  // namespace experiments
