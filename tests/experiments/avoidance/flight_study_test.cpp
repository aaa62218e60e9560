#include "experiments/avoidance/flight_study.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/experiments/program.h"
#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace experiments {
namespace {

const char kTiny[] =
    "title = \"tiny\"\nworlds = [\"still8\", \"moving5_05\"]\ncontrols = [\"blind\"]\n"
    "methods = [\"circular_buffer\"]\nseeds = 2\nframes = 30\n";

class FlightStudyTest : public Program {
 protected:
  std::string write(const std::string& text) { return folder_.write("tiny.toml", text).string(); }
  FlightStudy read(const std::string& text, const StudyOptions& options = {}) {
    const DataFolders shipped{tests::source_folder().string()};
    return read_flight_study(write(text), shipped.corridors, options);
  }
  /// What reading says after one part of the tiny study was replaced.
  std::string error_with(const std::string& part, const std::string& replacement) {
    std::string text = kTiny;
    text.replace(text.find(part), part.size(), replacement);
    return tests::message_of<ldm::InvalidInput>([&] { read(text); });
  }
  /// The world `still8` with one part of its file replaced, as another file.
  void write_world(const std::string& name, const std::string& part, const std::string& other) {
    std::string text =
        folder_.read(tests::source_folder() / "datasets" / "corridors" / "still8.toml");
    text.replace(text.find(part), part.size(), other);
    folder_.write(name, text);
  }
  /// The record's text up to its timing.
  std::string record(const std::string& id) {
    const std::string file = (folder_.path() / "record.json").string();
    TrialRequest request;
    request.study = write(kTiny);
    request.id = id;
    request.data_dir = tests::source_folder().string();
    EXPECT_EQ(run_flight_trial(request, file), std::nullopt);
    const std::string text = folder_.read("record.json");
    return text.substr(0, text.find("\n \"timing\""));
  }
};

TEST_F(FlightStudyTest, ListsEveryTrialOnceReplicateByReplicate) {
  const std::vector<FlightTrial> all = flight_trials(read(
      std::string(kTiny) + "first_seed = 7\n[sweep.axes]\n\"trust.margin_m\" = [0, 0.1, 0.2]\n"));
  std::set<std::string> ids;
  for (const FlightTrial& trial : all) ids.insert(trial.id);
  EXPECT_EQ(all.size(), 2U * 2U * 3U * 2U);
  EXPECT_EQ(ids.size(), all.size());
  EXPECT_EQ(all.front().id, "still8.blind.p01.s007");
  EXPECT_EQ(all.back().id, "moving5_05.circular_buffer.p03.s008");
}

TEST_F(FlightStudyTest, ShippedOnesCanBeRead) {
  const DataFolders shipped{tests::source_folder().string()};
  for (const char* name : {"avoidance", "avoidance_trust"}) {
    const std::filesystem::path file = shipped.studies.file(name);
    EXPECT_TRUE(is_flight_study(file));
    EXPECT_GT(flight_trials(read_flight_study(file, shipped.corridors)).size(), 100U);
  }
  EXPECT_FALSE(is_flight_study(shipped.studies.file("table1")));
}

TEST_F(FlightStudyTest, TunesOnSeedsOfItsOwn) {
  const DataFolders shipped{tests::source_folder().string()};
  const FlightStudy study = read_flight_study(shipped.studies.file("avoidance"), shipped.corridors);
  const FlightStudy tuning =
      read_flight_study(shipped.studies.file("avoidance_trust"), shipped.corridors);
  EXPECT_GE(tuning.first_seed, 1001) << "beyond the 100 seeds of a full study";
  EXPECT_LT(study.first_seed + study.seeds, 1001);
}

TEST_F(FlightStudyTest, NamesWhatIsWrong) {
  EXPECT_NE(error_with("still8", "nowhere").find("tiny.toml:2: unknown world nowhere: allowed: "),
            std::string::npos);
  EXPECT_NE(error_with("\"blind\"", "\"deaf\"").find("tiny.toml:3: unknown arm deaf: allowed: "),
            std::string::npos);
  EXPECT_NE(error_with("\"blind\"", "\"circular_buffer\"")
                .find("circular_buffer comes twice: allowed: each arm once"),
            std::string::npos);
  EXPECT_NE(error_with("30", "4000").find("frames = 4000: allowed: at most the 400 of still8"),
            std::string::npos);
  EXPECT_NE(error_with("30", "30\nspeed = 3").find("tiny.toml:7: speed"), std::string::npos);
  EXPECT_NE(error_with("30", "30\n[set]\n\"trust.margin_m\" = 2")
                .find("trust.margin_m = 2: allowed: a number in [0, 1]"),
            std::string::npos);
  EXPECT_NE(error_with("30", "30\n[set]\n\"trust.margins\" = 2").find("trust.margins = 2: allowed"),
            std::string::npos);
  EXPECT_NE(error_with("30", "30\n[set]\n\"particles.count\" = 9")
                .find("particles.count = 9: allowed: values that an arm of the study uses"),
            std::string::npos);
}

TEST_F(FlightStudyTest, TakesNoWorldOrNameTwice) {
  EXPECT_NE(error_with("moving5_05", "still8").find("tiny.toml:2: still8 comes twice: allowed: "),
            std::string::npos);
  const std::string odd = folder_.write("my study.toml", kTiny).string();
  expect_bad("trials '" + odd + "'", "name \"my study\": allowed: letters, digits, _ and -");
}

TEST_F(FlightStudyTest, SetsAndSweepsValuesOfItsWorlds) {
  write(std::string(kTiny) +
        "[set]\n\"scenario.sensor.range_m\" = [0.3, 7]\n"
        "[sweep.axes]\n\"scenario.sensor.range_sigma_m\" = [0.01, 0.5]\n");
  const auto scores = [&](const std::string& id) {
    const Result flown = ldm("trial tiny.toml " + id + " -o r.json");
    EXPECT_EQ(flown.code, 0) << flown.error;
    const std::string text = folder_.read("r.json");
    const std::size_t begin = text.find("\"scores\"");
    return text.substr(begin, text.find("\"timing\"") - begin);
  };
  EXPECT_NE(scores("still8.circular_buffer.p01.s001"), scores("still8.circular_buffer.p02.s001"));
  EXPECT_NE(error_with("30", "30\n[set]\n\"scenario.sensor.rnge_m\" = 7")
                .find("sensor.rnge_m = 7: allowed: a key that scenarios have; did you mean "
                      "sensor.range_m?"),
            std::string::npos);
  EXPECT_NE(error_with("30", "30\n[sweep.axes]\n\"scenario.uav.kind\" = [\"flight\"]"), "");
}

TEST_F(FlightStudyTest, RecordsTheSameFlightTwiceButForTheTimes) {
  const std::string first = record("still8.circular_buffer.s002");
  EXPECT_EQ(first, record("still8.circular_buffer.s002"));
  EXPECT_NE(first.find("\"status\": \"ok\""), std::string::npos);
  EXPECT_NE(first.find("\"outcome\": \"time_out\""), std::string::npos)
      << "3 s are too short for 20 m";
  EXPECT_NE(first.find("\"hit_obstacle\": null"), std::string::npos);
  EXPECT_NE(first.find("\"trust.margin_m\":"), std::string::npos);
}

TEST_F(FlightStudyTest, GivesEveryArmTheSameWorld) {
  const auto seed = [&](const std::string& id) {
    const std::string text = record(id);
    return text.substr(text.find("\"scenario\":\""), 30);
  };
  EXPECT_EQ(seed("still8.blind.s001"), seed("still8.circular_buffer.s001"));
  EXPECT_NE(seed("still8.blind.s001"), seed("still8.blind.s002"));
}

TEST_F(FlightStudyTest, RunsAsATrialOfTheProgram) {
  const std::string study = write(kTiny);
  const Result listed = ldm("trials tiny.toml");
  EXPECT_EQ(listed.code, 0) << listed.error;
  EXPECT_EQ(lines(listed.out), 8U);
  const Result run = ldm("trial tiny.toml still8.blind.s001 -o record.json");
  EXPECT_EQ(run.code, 0) << run.error;
  EXPECT_TRUE(exists("record.json"));
  expect_bad("trial tiny.toml still8.blind.s003 -o record.json", "study tiny has no trial");
}

TEST_F(FlightStudyTest, RecordsAFailureWithoutFlying) {
  write(kTiny);
  const Result run =
      ldm("trial tiny.toml still8.blind.s001 --failed 'killed by SIGSEGV' -o f.json");
  EXPECT_EQ(run.code, 0) << run.error;
  const std::string text = folder_.read("f.json");
  EXPECT_NE(text.find("\"status\": \"failed\""), std::string::npos);
  EXPECT_NE(text.find("\"error\": \"killed by SIGSEGV\""), std::string::npos);
  EXPECT_EQ(text.find("\"scores\""), std::string::npos);
}

TEST_F(FlightStudyTest, TellsProgramsWhatItIsMadeOf) {
  write(kTiny);
  const Result listed = ldm("trials tiny.toml --json");
  EXPECT_NE(listed.out.find("\"datasets/corridors/still8.toml\""), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find("{\"blind\":\"empty_map\",\"circular_buffer\":\"circular_buffer\"}"),
            std::string::npos);
}

/// The last word of what is printed is the obstacle's number.
TEST_F(FlightStudyTest, RecordsWhatWasHit) {
  const std::string told = ldm("fly blind still8 --seed 2 -o flown").out;
  ASSERT_TRUE(told.starts_with("hit_static after ")) << told;
  const std::string id = told.substr(told.rfind(' ') + 1, told.rfind('\n') - told.rfind(' ') - 1);
  EXPECT_NE(folder_.read("flown/summary.json").find("\"hit_obstacle\": " + id + ","),
            std::string::npos);
}

TEST_F(FlightStudyTest, FliesOnceWithALog) {
  const Result flown = ldm("fly circular_buffer still8 --seed 2 -o flown");
  EXPECT_EQ(flown.code, 0) << flown.error;
  EXPECT_EQ(lines(flown.out), 1U);
  const std::string samples = folder_.read("flown/flight.csv");
  EXPECT_TRUE(samples.starts_with("time_s,x_m,y_m,z_m,vx_mps,")) << samples.substr(0, 80);
  EXPECT_GT(lines(samples), 400U) << "50 rows a second";
  EXPECT_GT(lines(folder_.read("flown/obstacles.csv")), 8U * 20U);
  EXPECT_GT(lines(folder_.read("flown/plans.csv")), 16U * 20U);
  EXPECT_NE(folder_.read("flown/summary.json").find("\"scores\""), std::string::npos);
  const Result noisy =
      ldm("fly circular_buffer still8 --seed 2 -o noisy --set scenario.sensor.range_sigma_m=0.5");
  EXPECT_EQ(noisy.code, 0) << noisy.error;
  EXPECT_NE(folder_.read("noisy/flight.csv"), samples);
  expect_bad("fly circular_buffer still8 -o flown --set scenario.sensor.range_sigma_m=99",
             "--set: scenario: sensor.range_sigma_m = 99: allowed: a number in [0, 10]");
  expect_bad("fly nobody still8 -o flown", "unknown arm nobody: allowed: blind, ");
  expect_bad("fly ldm nowhere -o flown", "unknown world nowhere: allowed: ");
  expect_bad("fly ldm still8 -o flown --set flight.delay_s=2",
             "--set: flight.delay_s = 2: allowed: a number in [0, 1]");
  expect_bad("fly oracle still8 -o flown --set particles.count=9",
             "--set: particles.count = 9: allowed: values that the arm oracle uses");
}

/// Of a fake that keeps what it is fed: one picture a scan, and the last for a second more.
TEST_F(FlightStudyTest, FilmsAFlight) {
  const std::filesystem::path fake =
      folder_.write("bin/ffmpeg",
                    "#!/bin/sh\necho \"$@\" > arguments\ncat > pixels\n"
                    "echo film > \"$(eval echo \\${$#})\"\n");
  std::filesystem::permissions(fake, std::filesystem::perms::owner_all);
  write_world("short.toml", "frames = 400", "frames = 6");
  const Result flown = ldm("fly blind short.toml -o flown --video a.mp4", "PATH=$PWD/bin:$PATH");
  EXPECT_EQ(flown.code, 0) << flown.error;
  EXPECT_EQ(folder_.read("a.mp4"), "film\n");
  EXPECT_NE(folder_.read("arguments").find("-s 1280x720 -r 10 -i -"), std::string::npos);
  const std::string pixels = folder_.read("pixels");
  constexpr std::size_t kPicture = 1280UL * 720 * 3;
  ASSERT_EQ(pixels.size(), (6 + 10) * kPicture);
  const auto picture = [&](std::size_t i) { return pixels.substr(i * kPicture, kPicture); };
  EXPECT_NE(picture(0), picture(5));
  EXPECT_NE(picture(5), picture(6)) << "how it ended is added";
  EXPECT_EQ(picture(6), picture(15));
}

TEST_F(FlightStudyTest, RefusesBadFilms) {
  expect_bad("fly blind still8 -o flown --video a.avi", "--video a.avi: allowed: FILE.mp4");
  expect_bad("fly blind still8 -o flown --video none/a.mp4", "none/a.mp4: cannot be written");
  const Result without = ldm("fly blind still8 -o flown --video a.mp4", "PATH=/none");
  EXPECT_EQ(without.code, 2);
  EXPECT_NE(without.error.find("--video a.mp4: there is no ffmpeg"), std::string::npos);
  EXPECT_FALSE(exists("a.mp4"));
  EXPECT_FALSE(exists("flown/flight.csv"));
}

}  // namespace
}  // namespace experiments
